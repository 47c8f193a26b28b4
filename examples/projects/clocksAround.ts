import { build } from './buildProject.ts';

/** A film of clocks in all directions (scripts/clockFilm.mjs), flown through: its tempo is D. */
export const clocksAround = () =>
  build(
    {
      title: 'Clocks in a film',
      lookFor:
        'A 360° film of clocks, infinitely far away, whose hands go round in eight seconds, at 0.6 c. At first you stay in place, where all of them agree: press Tab to fly. By your own clock those ahead run twice as fast and those behind you half as fast, by the same factor as their colours shift; the mirror that you leave behind shows them, too. Stop (X): they run alike again, but no longer agree, since you are nearer to the light of those ahead.',
    },
    {
      panorama: { type: 'panorama', set: { source: 'panoramas/clocks.mp4', filmEnd: 'repeat', reading: 'filter' } },
      ball: { type: 'sphere', set: { name: 'Mirror', radius: 1.6, segments: 96, rings: 48 } },
      mirror: {
        type: 'material',
        set: { color: [0.95, 0.93, 0.88], roughness: 0.05, metallic: 1 },
        from: { geometry: 'ball.geometry' },
      },
      placed: { type: 'transform', set: { position: [2.4, -0.8, -7] }, from: { geometry: 'mirror.geometry' } },
      eye: { type: 'camera', set: { name: 'Eye', position: [0, 0, 0], target: [0, 0, -1], fieldOfView: 80 } },
      start: { type: 'observer', set: { beta: [0, 0, -0.6] } },
      scene: {
        type: 'scene',
        from: {
          geometry: ['placed.geometry', 'eye.geometry'],
          lights: ['panorama.lights'],
          observer: 'start.observer',
        },
      },
      console: { type: 'relativity-console', set: { speedOfLight: 10 }, from: { scene: 'scene.scene' } },
      camera: { type: 'scene-camera', from: { relativity: 'console.relativity' } },
      rasterize: { type: 'relativity-rasterize', from: { view: 'camera.view' } },
      light: { type: 'deferred-lighting', from: { gbuffer: 'rasterize.gbuffer' } },
      tone: { type: 'tone-map', from: { image: 'light.image' } },
      output: { type: 'output', from: { image: 'tone.image' } },
    },
  );
