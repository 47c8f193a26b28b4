import { build } from './buildProject.ts';

const ABOUT = {
  title: 'Checkerboards',
  lookFor:
    'The complete graph of the program that Slowlight follows (Zhu, Liu and Xia 2024, figure 14), with its test scene: cubes pass and a ball turns over a checkered floor, light goes at 10 m/s. Occlusion is smoothed and multiplied with the picture by an effect written in GLSL, far things fade into the sky, and a tenth of what an ordinary renderer draws shows where everything is.',
};

const MULTIPLY = `#version 430 core
uniform vec2 iResolution;
uniform sampler2D baseColorSampler1;
uniform sampler2D baseColorSampler2;
uniform float alpha;
layout(location = 0) out vec4 Color;

void main() {
  vec2 uv = gl_FragCoord.xy / iResolution;
  vec3 below = texture(baseColorSampler1, uv).rgb;
  vec3 above = texture(baseColorSampler2, uv).rgb;
  Color = vec4(mix(below, below * above, alpha), 1.0);
}
`;

const RED = { first: [0.75, 0.06, 0.04], second: [0.85, 0.8, 0.75] };
const GREEN = { first: [0.06, 0.45, 0.12], second: [0.85, 0.85, 0.8] };
const GRAY = { first: [0.5, 0.5, 0.5], second: [0.22, 0.22, 0.22] };

/** Figure 14 of the source documents: both rasterizers, occlusion by itself, denoised and multiplied, a sky with fog, and a mix of the two pictures. */
export const checkerboards = () =>
  build(ABOUT, {
    floor: { type: 'grid', set: { name: 'Floor', width: 60, length: 60, columns: 60, rows: 60 } },
    gray: { type: 'texture', set: { ...GRAY, countU: 12, countV: 12 }, from: { geometry: 'floor.geometry' } },

    cube: { type: 'box', set: { name: 'Cube' } },
    red: { type: 'texture', set: { ...RED, countU: 4, countV: 4 }, from: { geometry: 'cube.geometry' } },
    row: {
      type: 'instances',
      set: { countX: 5, countZ: 2, spacing: [3, 1, 3] },
      from: { geometry: 'red.geometry' },
    },
    standing: { type: 'transform', set: { position: [0, 0.5, -6] }, from: { geometry: 'row.geometry' } },
    passing: { type: 'motion-uniform', set: { velocity: [6, 0, 0], at: 3 } },
    cubes: { type: 'move', from: { geometry: 'standing.geometry', motion: 'passing.motion' } },

    ball: { type: 'sphere', set: { name: 'Ball', radius: 1.2 } },
    green: { type: 'texture', set: { ...GREEN, countU: 16, countV: 8 }, from: { geometry: 'ball.geometry' } },
    aloft: { type: 'transform', set: { position: [0, 1.3, -1.5] }, from: { geometry: 'green.geometry' } },
    turning: { type: 'motion-spin', set: { center: [0, 1.3, -1.5], rate: 5, to: 20 } },
    globe: { type: 'move', from: { geometry: 'aloft.geometry', motion: 'turning.motion' } },

    lamp: { type: 'lamp', set: { position: [3, 14, 4], brightness: 420 } },
    sky: {
      type: 'sky',
      set: { sky: 'gradient', zenith: [0.1, 0.2, 0.55], horizon: [0.5, 0.55, 0.75], ground: [0.2, 0.2, 0.22] },
    },
    eye: { type: 'camera', set: { position: [1.5, 2.4, 6.5], target: [0, 0.8, -3] } },
    time: { type: 'time', set: { to: 6, openAt: 3 } },
    scene: {
      type: 'scene',
      from: {
        geometry: ['gray.geometry', 'cubes.geometry', 'globe.geometry', 'eye.geometry'],
        lights: ['lamp.lights', 'sky.lights'],
        time: 'time.time',
      },
    },
    console: { type: 'relativity-console', set: { speedOfLight: 10 }, from: { scene: 'scene.scene' } },
    camera: { type: 'scene-camera', from: { relativity: 'console.relativity' } },

    seen: { type: 'relativity-rasterize', set: { grid: true }, from: { view: 'camera.view' } },
    lighting: { type: 'deferred-lighting', set: { occlusion: false }, from: { gbuffer: 'seen.gbuffer' } },
    occlusion: { type: 'ambient-occlusion', from: { gbuffer: 'seen.gbuffer' } },
    denoised: {
      type: 'post-process',
      set: { effect: 'bilateral-filter', arg1: 2 },
      from: { image: 'occlusion.mask' },
    },
    background: {
      type: 'post-process',
      set: { effect: 'sky-background', arg3: 60 },
      from: { image: 'lighting.image' },
    },
    shaded: {
      type: 'mix-color',
      set: { mode: 'written', text: MULTIPLY, alpha: 1 },
      from: { below: 'background.image', above: 'denoised.image' },
    },

    ordinary: { type: 'rasterize', from: { view: 'camera.view' } },
    plain: { type: 'deferred-lighting', from: { gbuffer: 'ordinary.gbuffer' } },
    both: {
      type: 'mix-color',
      set: { alpha: 0.1 },
      from: { below: 'shaded.image', above: 'plain.image' },
    },
    toneMap: { type: 'tone-map', from: { image: 'both.image' } },
    output: { type: 'output', from: { image: 'toneMap.image' } },
  });
