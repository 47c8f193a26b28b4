import { random } from '../../src/math/random.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import type { Mesh } from '../../src/scene/types.ts';
import type { Part, SceneBuilder } from './builder.ts';
import { paint } from './builder.ts';
import { Canvas, tone } from './paint.ts';
import { block, moved, polygon, quad } from './parts.ts';

/** One colour scheme of a row of town houses. */
export interface Scheme {
  readonly wall: string;
  readonly trim: string;
  readonly door: string;
  readonly shutter?: string;
}

export interface House {
  readonly width: number;
  readonly floors: number;
  readonly bays: number;
  readonly scheme: Scheme;
}

const GROUND = 3.6;
const FLOOR = 3.1;
/** Texture pixels per metre of facade. */
const SCALE = 40;
const GLASS = '#33424f';

export const wallHeight = (floors: number): number => GROUND + (floors - 1) * FLOOR;

/** The texture of a house front; windows have reveals, sills, bars and reflections of the sky. */
function facade({ width, floors, bays, scheme }: House, seed: number): Canvas {
  const height = wallHeight(floors);
  const [w, h] = [Math.round(width * SCALE), Math.round(height * SCALE)];
  const canvas = new Canvas(w, h, scheme.wall).grain(0.025, 2, seed).grain(0.02, 9, seed + 1);
  const y = (metres: number) => h - metres * SCALE;
  canvas.rect(0, y(0.55), w, h, tone(scheme.trim, 0.72));
  canvas.rect(0, y(0.6), w, y(0.55), tone(scheme.trim, 1.2));
  for (let floor = 1; floor < floors; floor++) {
    const level = GROUND + (floor - 1) * FLOOR;
    canvas.rect(0, y(level + 0.12), w, y(level - 0.12), scheme.trim);
    canvas.rect(0, y(level - 0.12), w, y(level - 0.18), tone(scheme.wall, 0.72));
  }
  const bay = width / bays;
  const doorBay = Math.floor(bays / 2);
  for (let floor = 0; floor < floors; floor++)
    for (let i = 0; i < bays; i++) {
      const middle = (i + 0.5) * bay * SCALE;
      const base = floor === 0 ? 0 : GROUND + (floor - 1) * FLOOR;
      if (floor === 0 && i === doorBay) door(canvas, middle, y, scheme);
      else window(canvas, middle, y, base + SILL, windowWidth(bay), windowHeight(floor), scheme);
    }
  return canvas;
}

/** Size of windows [m]. */
const SILL = 0.95;
const windowWidth = (bay: number): number => Math.min(1.1, bay * 0.5);
const windowHeight = (floor: number): number => (floor === 0 ? 1.75 : 1.6);

/** Lit window panes, just in front of the facade; the window's bars stay between them. */
function litPanes({ width, floors, bays }: House, seed: number): Mesh[] {
  const next = random(seed + 7);
  const bay = width / bays;
  const panes: Mesh[] = [];
  for (let floor = 0; floor < floors; floor++)
    for (let i = 0; i < bays; i++) {
      const isDoor = floor === 0 && i === Math.floor(bays / 2);
      if (isDoor || next() > 0.5) continue;
      const base = (floor === 0 ? 0 : GROUND + (floor - 1) * FLOOR) + SILL;
      const [w, h] = [windowWidth(bay) / 2, windowHeight(floor) / 3];
      for (const side of [0, 1])
        for (const row of [0, 1, 2]) {
          const x = (i + 0.5) * bay - width / 2 + (side - 1) * w;
          const [x0, x1, y0, y1] = [x + 0.05, x + w - 0.04, base + row * h + 0.03, base + (row + 1) * h - 0.05];
          panes.push(quad([x0, y0, 0.012], [x1, y0, 0.012], [x1, y1, 0.012], [x0, y1, 0.012]));
        }
    }
  return panes;
}

function window(
  canvas: Canvas,
  x: number,
  y: (m: number) => number,
  sill: number,
  width: number,
  height: number,
  scheme: Scheme,
): void {
  const half = (width / 2) * SCALE;
  const [top, bottom] = [y(sill + height), y(sill)];
  const frame = 0.13 * SCALE;
  canvas.rect(x - half - frame, top - frame * 1.5, x + half + frame, bottom, scheme.trim);
  canvas.rect(x - half - frame, top - frame * 1.7, x + half + frame, top - frame * 1.35, tone(scheme.trim, 1.4));
  canvas.rect(x - half - frame * 1.5, bottom, x + half + frame * 1.5, bottom + frame * 0.7, tone(scheme.trim, 1.3));
  canvas.rect(
    x - half - frame * 1.5,
    bottom + frame * 0.7,
    x + half + frame * 1.5,
    bottom + frame * 1.1,
    tone(scheme.wall, 0.6),
  );
  canvas.rect(x - half, top, x + half, bottom, tone(scheme.trim, 0.5));
  for (const [i, j] of [
    [0, 0],
    [1, 0],
    [0, 1],
    [1, 1],
    [0, 2],
    [1, 2],
  ]) {
    const x0 = x - half + 3 + i * (half - 1);
    const y0 = top + 4 + (j * (bottom - top - 4)) / 3;
    const y1 = top + ((j + 1) * (bottom - top - 4)) / 3;
    canvas.rect(x0, y0, x0 + half - 5, y1, tone(GLASS, 1.22 - j * 0.1));
    canvas.rect(x0, y0, x0 + half - 5, y0 + (y1 - y0) * 0.35, tone(GLASS, 1.42 - j * 0.1));
  }
  if (!scheme.shutter) return;
  for (const side of [-1, 1]) {
    const inner = x + side * (half + frame * 1.1);
    const outer = inner + side * half * 0.92;
    canvas.rect(Math.min(inner, outer), top, Math.max(inner, outer), bottom, scheme.shutter);
    for (let line = top + 3; line < bottom - 2; line += 5)
      canvas.rect(Math.min(inner, outer) + 2, line, Math.max(inner, outer) - 2, line + 2, tone(scheme.shutter, 0.72));
  }
}

function door(canvas: Canvas, x: number, y: (m: number) => number, scheme: Scheme): void {
  const half = 0.62 * SCALE;
  const frame = 0.2 * SCALE;
  canvas.rect(x - half - frame, y(2.95), x + half + frame, y(0), scheme.trim);
  canvas.rect(x - half - frame * 1.4, y(3.1), x + half + frame * 1.4, y(2.92), tone(scheme.trim, 1.3));
  canvas.rect(x - half, y(2.7), x + half, y(0), tone(scheme.door, 0.55));
  canvas.rect(x - half + 2, y(2.2), x + half - 2, y(0.04), scheme.door);
  canvas.rect(x - half + 2, y(2.66), x + half - 2, y(2.26), tone(GLASS, 1.35));
  for (const [i, j] of [
    [0, 0],
    [1, 0],
    [0, 1],
    [1, 1],
  ]) {
    const x0 = x - half + 6 + i * (half - 2);
    const y0 = y(2.05 - j * 1.0);
    canvas.rect(x0, y0, x0 + half - 9, y0 + 0.8 * SCALE, tone(scheme.door, 0.78));
    canvas.rect(x0 + 2, y0 + 2, x0 + half - 9, y0 + 0.8 * SCALE, tone(scheme.door, 1.1));
  }
  canvas.rect(x + half - 8, y(1.1), x + half - 5, y(1.0), '#d8b860');
}

/** Materials shared by a row of houses. */
export interface HouseMaterials {
  readonly roof: number;
  readonly stone: number;
  readonly chimney: number;
  /** Material of lit panes; absent: none is lit. */
  readonly glow?: number;
}

/**
 * A town house with its front at z = 0 facing +Z, centred at x = 0: textured front, plain sides, cornice, gabled tile roof with
 * eaves, chimney and a door step.
 */
export function house(
  builder: SceneBuilder,
  name: string,
  style: House,
  materials: HouseMaterials,
  seed: number,
): Part {
  const { width, floors, scheme } = style;
  const [w, h, depth] = [width / 2, wallHeight(floors), 9];
  const front = builder.material(`${name}_front`, '#ffffff', {
    texture: facade(style, seed).texture(`${name}_front`),
    roughness: 0.9,
  });
  const side = builder.material(`${name}_side`, tone(scheme.wall, 0.96), { roughness: 0.95 });
  const trim = builder.material(`${name}_trim`, scheme.trim, { roughness: 0.8 });

  const rise = 0.36 * depth;
  const walls: Part = [
    paint(quad([-w, 0, 0], [w, 0, 0], [w, h, 0], [-w, h, 0]), front),
    paint(
      polygon([
        [w, 0, 0],
        [w, 0, -depth],
        [w, h, -depth],
        [w, h + rise, -depth / 2],
        [w, h, 0],
      ]),
      side,
    ),
    paint(
      polygon([
        [-w, 0, -depth],
        [-w, 0, 0],
        [-w, h, 0],
        [-w, h + rise, -depth / 2],
        [-w, h, -depth],
      ]),
      side,
    ),
    paint(
      polygon([
        [w, 0, -depth],
        [-w, 0, -depth],
        [-w, h, -depth],
        [w, h, -depth],
      ]),
      side,
    ),
  ];
  const cornice: Part = [
    paint(block(width + 0.16, 0.28, 0.22, 1, [0, h - 0.28, 0.1]), trim),
    paint(block(width + 0.3, 0.12, 0.4, 1, [0, h - 0.02, 0.18]), trim),
  ];
  const chimney = paint(block(0.75, 2.1, 0.75, 1, [w * 0.5, h + rise * 0.55, -depth * 0.62]), materials.chimney);
  const pot = paint(block(0.95, 0.16, 0.95, 1, [w * 0.5, h + rise * 0.55 + 2.1, -depth * 0.62]), materials.stone);
  const steps = [block(2.1, 0.17, 0.9, 1, [0, 0, 0.45]), block(1.7, 0.17, 0.45, 1, [0, 0.17, 0.22])].map((m) =>
    paint(moved(m, [doorOffset(style), 0, 0]), materials.stone),
  );
  return [
    ...walls,
    ...(materials.glow === undefined ? [] : litPanes(style, seed).map((m) => paint(m, materials.glow!))),
    ...cornice,
    ...roof(w, h, depth, rise).map((m) => paint(m, materials.roof)),
    chimney,
    pot,
    ...steps,
  ];
}

const doorOffset = ({ width, bays }: House): number => ((Math.floor(bays / 2) + 0.5) / bays - 0.5) * width;

/** Two slopes with eaves and a visible thickness. */
function roof(w: number, h: number, depth: number, rise: number) {
  const [eave, verge, thick] = [0.5, 0.12, 0.14];
  const slope = rise / (depth / 2);
  const x = w + verge;
  const ridge: [number, number] = [h + rise + thick, -depth / 2];
  const low = h - slope * eave + thick;
  const p = (side: number, y: number, z: number): Vec3 => [side * x, y, z];
  const back = -depth - eave;
  return [
    polygon([p(-1, low, eave), p(1, low, eave), p(1, ...ridge), p(-1, ...ridge)], 0.5),
    polygon([p(1, low, back), p(-1, low, back), p(-1, ...ridge), p(1, ...ridge)], 0.5),
    polygon([p(-1, low - thick, eave), p(1, low - thick, eave), p(1, low, eave), p(-1, low, eave)], 0.5),
    polygon([p(1, low - thick, eave), p(1, ridge[0] - thick, ridge[1]), p(1, ...ridge), p(1, low, eave)], 0.5),
    polygon([p(1, ridge[0] - thick, ridge[1]), p(1, low - thick, back), p(1, low, back), p(1, ...ridge)], 0.5),
    polygon([p(-1, ridge[0] - thick, ridge[1]), p(-1, low - thick, eave), p(-1, low, eave), p(-1, ...ridge)], 0.5),
    polygon([p(-1, low - thick, back), p(-1, ridge[0] - thick, ridge[1]), p(-1, ...ridge), p(-1, low, back)], 0.5),
  ];
}
