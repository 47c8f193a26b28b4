import { fromAxisAngle, multiply } from '../../src/math/quat.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { sphere } from '../../src/scene/mesh/primitives.ts';
import type { Scene } from '../../src/scene/types.ts';
import { at, compose, daylight, type Part, paint, place, placePart, SceneBuilder } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera, sampled, smoothRamp } from '../kit/flight.ts';
import { Canvas, checker } from '../kit/paint.ts';
import { roundedBox, turned } from '../kit/parts.ts';
import { street } from '../kit/street.ts';

export const scene: ExampleScene = { name: 'street', make };

function make(): Scene {
  const builder = new SceneBuilder();
  const road = builder.material('floor', '#ffffff', {
    texture: checker('#c9c2b4', '#6f7377', 'floor', 2, 64),
    roughness: 0.85,
  });
  // Half a kilometre: room to fly for a minute at the speed of light.
  street(builder, { road, lamp: builder.material('lamp', '#fff4d6', { emissive: '#ffdf9e' }), repeats: 4 });
  movers(builder);
  const [from, to] = [0, 14];
  const flight = camera({
    from,
    to,
    fovY: 60,
    position: (t) => [1.1 * Math.sin(0.22 * t), 1.9, 46 - 84 * smoothRamp(t / to, 0.34)],
    target: (t) => [0.8 * Math.sin(0.22 * t), 2.5, 46 - 84 * smoothRamp(t / to, 0.34) - 20],
  });
  const hints = {
    speedOfLight: 10,
    title: 'Street',
    lookFor:
      'Fly down the street at 0.9 c. Everything crowds towards where you are going: you see house fronts that you have already passed. Doors, lamps and columns bend, while kerbs and eaves along your way stay straight. What is ahead turns blue and bright, what is behind red and dark.',
    openAt: 1.2,
  };
  return builder.finish('street', hints, [from, to], [flight], daylight([0.55, 0.75, 0.42]));
}

/** Three moving cubes, and a sphere that rotates on a plinth. */
function movers(builder: SceneBuilder): void {
  const stone = builder.material('plinth', '#d8d2c4', { roughness: 0.7 });
  const colors: readonly [string, string][] = [
    ['#d1603d', '#f3e9d8'],
    ['#2f7f86', '#f3e9d8'],
    ['#e0a93b', '#463f3a'],
  ];
  const cubes = colors.map(([dark, light], i) =>
    builder.material(`cube${i}`, '#ffffff', { texture: checker(light, dark, `cube${i}`, 4, 32), roughness: 0.45 }),
  );
  const cube = (i: number, size = 1.7): Part => [paint(roundedBox([size, size, size], 0.06), cubes[i])];

  builder.object(
    '/World/CubeAcross',
    cube(0),
    sampled(0, 14, 30, (t) => ({
      position: [3.1 * Math.sin(2.2 * t), 1.15, 22],
      orientation: fromAxisAngle([0, 1, 0], 0.5),
    })),
  );
  builder.object('/World/CubeAhead', cube(1), {
    kind: 'uniform',
    pose: { position: [-2.6, 1.15, 40], orientation: fromAxisAngle([0, 1, 0], 0.2) },
    velocity: [0, 0, -3.5],
  });
  builder.object('/World/CubeOncoming', cube(2), {
    kind: 'uniform',
    pose: { position: [2.7, 1.15, -78], orientation: fromAxisAngle([0, 1, 0], -0.3) },
    velocity: [0, 0, 5],
  });

  const ball = builder.material('globe', '#ffffff', { texture: globe(), roughness: 0.35 });
  const middle: Vec3 = [0, 3.1, -32];
  builder.object(
    '/World/Plinth',
    placePart(
      [
        paint(
          turned(
            [
              [1.5, 0],
              [1.5, 0.3],
              [1.1, 0.45],
              [1.0, 1.2],
              [1.25, 1.35],
              [1.25, 1.5],
            ],
            32,
          ),
          stone,
        ),
      ],
      compose(place([0, 0, -32])),
    ),
    at([0, 0, 0]),
  );
  const tilt = fromAxisAngle([0, 0, 1], -0.3);
  builder.object(
    '/World/Globe',
    [paint(sphere(1.5, { segments: 56, rings: 28, axis: 'Y' }), ball)],
    sampled(0, 14, 30, (t) => ({ position: middle, orientation: multiply(tilt, fromAxisAngle([0, 1, 0], 4.5 * t)) })),
  );
}

function globe() {
  return new Canvas(256, 128, '#ffffff')
    .shade((u, v) => {
      const field = (Math.floor(u * 12) + Math.floor(v * 6)) % 2 === 0;
      const line = Math.abs(((u * 12) % 1) - 0.5) > 0.46 || Math.abs(((v * 6) % 1) - 0.5) > 0.46;
      return line ? '#26323a' : field ? '#e8e0cf' : '#b8493a';
    })
    .texture('globe');
}
