/**
 * Whether graphics are rendered in software. Antialiasing then takes most of the time, and drawings are faster on a
 * canvas without the emulated graphics card.
 */
export const drawnInSoftware: boolean = (() => {
  const gl = document.createElement('canvas').getContext('webgl2'),
    info = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = gl && info ? String(gl.getParameter(info.UNMASKED_RENDERER_WEBGL)) : '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
})();
