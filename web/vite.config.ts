import { defineConfig } from 'vite';

// Few files with fixed names: the server embeds whatever is in dist.
export default defineConfig(async ({ command }) => ({
  base: './',
  plugins: command === 'serve' && process.env.PLANISH_MOCK ? [(await import('./dev/mock')).mock()] : [],
  server: {
    proxy: process.env.PLANISH_SERVER
      ? { '/api': { target: process.env.PLANISH_SERVER, changeOrigin: true, headers: { origin: process.env.PLANISH_SERVER } } }
      : undefined,
  },
  build: {
    target: 'es2022',
    modulePreload: false as const,
    chunkSizeWarningLimit: 1500,
    rollupOptions: {
      output: {
        entryFileNames: 'studio.js',
        chunkFileNames: 'studio-[name].js',
        assetFileNames: 'studio[extname]',
      },
    },
  },
}));
