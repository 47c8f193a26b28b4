import { COULOMB_CONSTANT } from '../../src/dynamics/forces/coulomb.ts';
import type { Scene, Texture } from '../../src/scene/types.ts';
import { paint, SceneBuilder, sun } from '../kit/builder.ts';
import type { ExampleScene } from '../kit/example.ts';
import { Canvas, rgb } from '../kit/paint.ts';
import { disc, turned } from '../kit/parts.ts';
import { AWAY, C, CHARGE, SPEED } from '../projects/charges.ts';

export const set: ExampleScene = { name: 'planetarium', make };

const RADIUS = 2.3;
/** Advance of the apsides per radial period [rad], so that the orbit closes after eight periods, and the number of revolutions until then. */
const [RAY, ROUNDS] = [Math.PI / 4, 9];
/** Size of the chart [px]. */
const [SIZE, FIELD] = [1024, '#16264a'];

/** A round table under the stars, with the theoretical orbit of two charges. */
function make(): Scene {
  const builder = new SceneBuilder();
  const paper = builder.material('chart', '#ffffff', { texture: chart(), roughness: 0.6 });
  const brass = builder.material('brass', '#b98d44', { roughness: 0.35, metallic: 0.6 });
  const rim = turned(
    [
      [0.5, -1.4],
      [0.3, -1.3],
      [0.3, -0.35],
      [RADIUS - 0.1, -0.14],
      [RADIUS + 0.06, -0.12],
      [RADIUS + 0.06, 0.02],
      [RADIUS, 0.02],
      [RADIUS, 0],
    ],
    96,
  );
  builder.object('/World/Table', [paint(disc(RADIUS, 96), paper), paint(rim, brass)]);
  const moon = { ...sun([0.6, 0.3, -0.5], '#9db8ff', 0.5), path: '/World/Moon' };
  return builder.finish('planetarium', {}, [0, 0], [], [sun([-0.35, 0.85, 0.4], '#fff4e2', 2.4), moon]);
}

/**
 * The orbit of two opposite charges of equal mass (Sommerfeld 1916, for a moving force centre): with their distance r = 1/u,
 * u″ + κ²u = kW/(4c²L²) by the angle, κ² = 1 − k²/(4c²L²), W = E + 2mc². Here m = 1 kg, and they start at the largest distance.
 */
export function orbit(): (angle: number) => { readonly away: number; readonly slope: number } {
  const k = COULOMB_CONSTANT * CHARGE ** 2;
  const gamma = 1 / Math.sqrt(1 - (SPEED / C) ** 2);
  const L = 2 * AWAY * gamma * SPEED;
  const W = 2 * gamma * C ** 2 - k / (2 * AWAY);
  const kappa = Math.sqrt(1 - (k / (2 * C * L)) ** 2);
  const mean = (k * W) / (2 * C * L * kappa) ** 2;
  const swing = 1 / (2 * AWAY) - mean;
  return (angle) => {
    const u = mean + swing * Math.cos(kappa * angle);
    return { away: 1 / (2 * u), slope: (swing * kappa * Math.sin(kappa * angle)) / (2 * u * u) };
  };
}

/** Top view, as wide as the table: the rosette until it closes, rays, and the circle that it touches. */
function chart(): Texture {
  const way = orbit();
  const near = (off: number, width: number): number => Math.max(0, 1 - Math.abs(off) / width);
  const canvas = new Canvas(SIZE, SIZE, FIELD).shade((u, v) => {
    const [x, y] = [(2 * u - 1) * RADIUS, (2 * v - 1) * RADIUS];
    const [r, angle] = [Math.hypot(x, y), Math.atan2(y, x)];
    const ray = (angle / RAY - Math.round(angle / RAY)) * RAY * r;
    const lines = Array.from({ length: ROUNDS }, (_, n) => {
      const { away, slope } = way(angle + 2 * Math.PI * (n - (ROUNDS - 1) / 2));
      return near((r - away) / Math.hypot(1, slope / away), 0.014);
    });
    const thin = Math.max(r < RADIUS - 0.12 ? 0.5 * near(ray, 0.009) : 0, near(r - AWAY, 0.012));
    return mixed(mixed(FIELD, '#8fb0d8', stepped(thin)), '#e9bf5a', stepped(Math.max(...lines)));
  });
  return canvas.texture('chart');
}

/** In steps that nobody sees, so few that the chart has a palette. */
const stepped = (share: number): number => Math.round(12 * share) / 12;

/** Interpolates two colours, 0 … 1. */
function mixed(from: string, to: string, share: number): string {
  const [a, b] = [rgb(from), rgb(to)];
  const bytes = a.map((x, i) => Math.round(x + (b[i]! - x) * share));
  return `#${bytes.map((x) => x.toString(16).padStart(2, '0')).join('')}`;
}
