import { defineConfig } from 'vite';

// PLANISH_SERVER=http://127.0.0.1:PORT: the server that `vite` and `vite preview` ask; open their address with its
// #TOKEN.
const target = process.env.PLANISH_SERVER;

// Few files with fixed names: the server embeds whatever is in dist.
export default defineConfig({
  base: './',
  server: { proxy: target ? { '/api': { target, changeOrigin: true, headers: { origin: target } } } : undefined },
  build: {
    target: 'es2022',
    modulePreload: false,
    chunkSizeWarningLimit: 1500,
    rollupOptions: {
      output: { entryFileNames: 'studio.js', chunkFileNames: 'studio-[name].js', assetFileNames: 'studio[extname]' },
    },
  },
});
