import { Color, DoubleSide, FrontSide, ShaderMaterial } from 'three';

// Light from above, from the upper left of the viewer and from the viewer, computed at corners: sheets are shaded by
// few and large triangles, and a picture is cheap even if drawn by the CPU.
const vertexShader = /* glsl */ `
  #include <clipping_planes_pars_vertex>
  uniform bool twoSided;
  uniform float lit;
  uniform vec3 light;
  attribute vec3 tint;
  attribute float row;
  varying vec3 shade;
  void main() {
    vec3 n = normalize(normalMatrix * normal);
    if (twoSided && n.z < 0.0) n = -n;
    float above = 0.5 + 0.5 * dot(n, normalize((viewMatrix * vec4(0.0, 0.6, 0.8, 0.0)).xyz));
    float key = max(dot(n, vec3(-0.42, 0.66, 0.62)), 0.0);
    float bright = 0.30 + 0.14 * above + 0.46 * key + 0.22 * max(n.z, 0.0);
    float gleam = 0.10 * pow(max(dot(n, vec3(-0.23, 0.37, 0.90)), 0.0), 40.0);
    vec3 own = abs(row - lit) < 0.5 ? mix(tint, light, 0.45) : tint;
    shade = pow(own * bright + gleam, vec3(1.0 / 2.2));
    vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
    gl_Position = projectionMatrix * mvPosition;
    #include <clipping_planes_vertex>
  }`;

const fragmentShader = /* glsl */ `
  #include <clipping_planes_pars_fragment>
  uniform float opacity;
  varying vec3 shade;
  void main() {
    #include <clipping_planes_fragment>
    gl_FragColor = vec4(shade, opacity);
  }`;

/**
 * For geometries with normals, an attribute `tint`, linear colours at corners, and one `row`, the part: that of row
 * `lit` has some of the colour `light`. `skin`: what is seen from its front alone.
 */
export function sheetMaterial(skin: boolean): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader,
    fragmentShader,
    side: skin ? FrontSide : DoubleSide,
    uniforms: { twoSided: { value: !skin }, lit: { value: -1 }, light: { value: new Color() }, opacity: { value: 1 } },
    clipping: true,
    polygonOffset: true,
    polygonOffsetFactor: 1.5,
    polygonOffsetUnits: 1,
  });
}

/** Whether one sees through it. */
export function setOpacity(material: ShaderMaterial, glass: boolean) {
  material.transparent = glass;
  material.depthWrite = !glass;
  material.uniforms.opacity!.value = glass ? 0.32 : 1;
}
