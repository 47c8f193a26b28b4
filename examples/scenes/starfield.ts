import { fromAxisAngle, multiply } from '../../src/math/quat.ts';
import { normalize, scale, type Vec3 } from '../../src/math/vec3.ts';
import { sphere, torus } from '../../src/scene/mesh/primitives.ts';
import { brightStars } from '../../src/scene/stars/brightStars.ts';
import { EQUATORIAL } from '../../src/scene/stars/equatorial.ts';
import type { Light, Scene } from '../../src/scene/types.ts';
import { at, paint, SceneBuilder } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { camera, smoothRamp } from '../kit/flight.ts';
import { linear } from '../kit/paint.ts';
import { moved } from '../kit/parts.ts';

/** [m] */
const SPACING = 12;
const GATES = 18;
const RADIUS = 5;

/** Orion, 84° from the vernal equinox, is straight ahead: along −X. */
const SKY = multiply(fromAxisAngle([0, 1, 0], (6 * Math.PI) / 180), EQUATORIAL);

export const scene: ExampleScene = { name: 'starfield', make };

function make(): Scene {
  const builder = new SceneBuilder();
  gates(builder);
  const [from, to] = [0, 24];
  const way = (t: number): number => 30 - 210 * smoothRamp(t / to, 0.42);
  const flight = camera({
    from,
    to,
    fovY: 60,
    position: (t) => [way(t), 0.6, 0.8],
    target: (t) => [way(t) - 10, 0.6, 0.8],
  });
  const hints = {
    speedOfLight: 16,
    title: 'Starfield',
    lookFor:
      'The real stars, with Orion straight ahead. As you speed up they crowd together in front of you: at 0.9 c the whole half of the sky that was ahead fits into a circle of 26°, and the belt shrinks to less than a quarter. Reddish Betelgeuse turns blue-white; look back, and the sky is empty and dark red.',
    openAt: 10,
  };
  const sun = scale(linear('#fff1dc'), 2.2);
  const lights: Light[] = [
    { kind: 'stars', path: '/World/Stars', stars: brightStars(), orientation: SKY, gain: 40 },
    { kind: 'distant', path: '/World/Sun', direction: normalize([-0.7, -0.55, -0.45]), color: sun },
  ];
  return builder.finish('starfield', hints, [from, to], [flight], lights);
}

/** A lane of hoops with lamps, as a nearby reference for the distant stars. */
function gates(builder: SceneBuilder): void {
  const metal = builder.material('metal', '#8b929c', { roughness: 0.35, metallic: 0.6 });
  const colors = ['#ffd9a0', '#a8d4ff'].map((color, i) =>
    builder.material(`lamp${i}`, '#202020', { emissive: color, roughness: 0.6 }),
  );
  for (let k = 0; k < GATES; k++) {
    const hoop = torus(RADIUS, 0.09, { segments: 48, rings: 8, axis: 'X' });
    const lamps = Array.from({ length: 12 }, (_, i): Vec3 => {
      const a = ((i + 0.5) * Math.PI) / 6;
      return [0, RADIUS * Math.cos(a), RADIUS * Math.sin(a)];
    }).map((place) => paint(moved(sphere(0.17, { segments: 10, rings: 6 }), place), colors[k % 2]));
    builder.object(`/World/Gate${k}`, [paint(hoop, metal), ...lamps], at([18 - SPACING * k, 0, 0]));
  }
}
