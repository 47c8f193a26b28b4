import { normalize } from '../../src/math/vec3.ts';
import type { Light, Scene } from '../../src/scene/types.ts';
import { SceneBuilder, sky, spectralLight } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera, smoothRamp } from '../kit/flight.ts';
import { street } from '../kit/street.ts';

/** Colour temperatures of the low sun and of gaslight [K]. */
const [SUN, GAS] = [2400, 2200];

export const scene: ExampleScene = { name: 'sunset', texturesOf: 'street', make };

function make(): Scene {
  const builder = new SceneBuilder();
  street(builder, {
    road: builder.material('asphalt', '#5f5e5b', { roughness: 0.95, like: 'asphalt' }),
    lamp: builder.material('lamp', '#fff4d6', { emissive: '#ffffff', emissionTemperature: GAS }),
    glow: builder.material('window', '#2a2520', { emissive: '#b8b8b8', emissionTemperature: GAS, roughness: 0.4 }),
  });
  const [from, to] = [0, 16];
  const way = (t: number): number => 48 - 82 * smoothRamp(t / to, 0.38);
  const flight = camera({
    from,
    to,
    fovY: 62,
    position: (t) => [-0.8 + 0.6 * Math.sin(0.2 * t), 1.9, way(t)],
    target: (t) => [-0.6 + 0.4 * Math.sin(0.2 * t), 2.9, way(t) - 20],
  });
  const hints = {
    speedOfLight: 10,
    title: 'Sunset street',
    lookFor:
      'The last of the sun, and gaslight behind the windows. Fly at 0.8 c: straight ahead you see by infrared alone. Trees, darker than the walls a moment ago, are as bright as they, and the asphalt stays dark; yellow windows turn white, for a glow of 2200 K then looks like one of 6600 K. Sunlit walls turn white as well, and what only the sky lights is blue.',
    openAt: 5,
  };
  const lights: Light[] = [
    { kind: 'distant', path: '/World/Sun', direction: normalize([-0.42, -0.24, -0.87]), ...spectralLight(sun, 1.8) },
    sky('#7f7fa6', '#c98f78', '#5d5557'),
  ];
  return builder.finish('sunset', hints, [from, to], [flight], lights);
}

const sun = { kind: 'thermal', temperature: SUN } as const;
