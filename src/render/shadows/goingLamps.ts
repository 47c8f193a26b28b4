import { uniform } from 'three/tsl';
import { add, addScaled, normalize } from '../../math/vec3.ts';
import type { Float, Int } from '../../shaders/types.ts';
import type { Body } from '../bodies.ts';
import type { Gpu } from '../device.ts';
import { type KnownLamp, lampEventFor } from '../lampTable.ts';
import { meet, type RelativeEvent, type Sight } from '../sight.ts';
import { type Drawing, HeightMap } from './heightMap.ts';
import { type Beam, BODY_TEXELS, type PointMaps, passingBodies, passingRound } from './lampReceiver.ts';
import { facesOf, lampLayer, middleOf, setRoom } from './lampRoom.ts';
import { LayerTable } from './layerTable.ts';
import { centreOf, largest, lift, type Mover, MovingBodies } from './movingBodies.ts';
import { ballLayer, CELLS, isNear, pointTexels } from './pointLayer.ts';
import { pointBend, type Tiling, toPoint } from './pointward.ts';
import type { Event } from './receiver.ts';
import { MAP_WIDTH } from './restingLamps.ts';
import { isAlwaysThere } from './restingShadows.ts';
import type { Occluders } from './shadowMaps.ts';

/** Fewest bodies that have tiles of their own under each lamp, and tiles of a lamp that moves. */
const FEWEST = 2;
const FACES = 6;

/**
 * Shadows of lamps where something goes. A body that a lamp goes past, whichever of the two it is, has a tile of its own for that lamp, as it looks
 * from the event that lights the body's centre. What rests and is too large or too near for that is on six tiles round a lamp that moves,
 * as they are from where the lamp is seen to be.
 */
export class GoingLamps {
  private readonly lamps: number;
  private readonly moving: readonly Body[];
  /** Bodies that rest where some lamp moves. */
  private readonly resting: readonly Body[];
  /** Tiles of bodies for each lamp. */
  private readonly most: number;
  private readonly map: HeightMap;
  /** Layers of receivers: for each lamp those of its bodies, then for each lamp its own; then in the same order those of occluders, a lamp's for each of its faces. */
  private readonly table: LayerTable;
  private readonly bodies: MovingBodies;
  private readonly tiling: Tiling;
  private readonly radius: number;
  /** 1 while what is round a lamp is drawn. */
  private readonly round = uniform(0, 'int');
  private made = '';

  constructor(occluders: Occluders, lamps: readonly KnownLamp[], gpu: Gpu) {
    const { bodies, detail, radius } = occluders;
    const goes = lamps.some(({ lamp }) => lamp.motion.kind !== 'static');
    this.lamps = lamps.length;
    this.radius = radius;
    this.moving = lamps.length > 0 ? bodies.filter((body) => !isAlwaysThere(body)) : [];
    this.resting = goes ? bodies.filter(isAlwaysThere) : [];
    const all = this.moving.length + this.resting.length;
    const share = Math.floor(detail.lampBodies / Math.max(1, lamps.length));
    this.most = Math.min(Math.max(FEWEST, share), detail.movers, all);
    const side = detail.lampTiles[1];
    this.tiling = { side, columns: MAP_WIDTH / side };
    this.map = new HeightMap(gpu, { cell: side / CELLS, bend: pointBend(side) });
    this.table = new LayerTable(lamps.length * (2 * this.most + 1 + FACES), BODY_TEXELS);
    this.bodies = new MovingBodies(occluders);
    if (all === 0) return;
    const own = new Set([...this.moving, ...this.resting]);
    this.bodies.drawInto(this.map, own, toPoint(this.map, this.table, side), this.round);
  }

  /** undefined where nothing goes; `moves`: whether the lamp does. */
  passing(slot: Int | number, moves: boolean, event: Event, beam: Beam, taps: number): Float | undefined {
    if (this.most === 0) return undefined;
    const { map, table, tiling, lamps, most } = this;
    const maps: PointMaps = { map, table, tiling, taps };
    const [first, own] =
      typeof slot === 'number' ? [slot * most, lamps * most + slot] : [slot.mul(most), slot.add(lamps * most)];
    const past = passingBodies(maps, first, most, event, beam);
    return moves ? past.mul(passingRound(maps, own, event, beam)) : past;
  }

  /** Makes the map that a picture needs; false where samples of a deforming mesh have still to come. */
  update(lamps: readonly KnownLamp[], sight: Sight): boolean {
    if (this.most === 0) return true;
    const { table, most, moving } = this;
    for (let layer = 0; layer < lamps.length * (2 * most + 1 + FACES); layer++) table.clear(layer);
    const going = lamps.filter(({ lamp }) => lamp.motion.kind !== 'static');
    const aside = this.resting.filter((body) => {
      const event = meet(body.line, sight);
      return event && going.every((lamp) => !isNear(lampFrom(lamp, event, sight).offset, body.radius));
    });
    const movers = largest([...moving, ...aside], sight).slice(0, most);
    const own = new Set(movers.map(({ body }) => body));
    const round = this.resting.filter((body) => !own.has(body));
    const shapes = this.bodies.place(movers, sight, { bodies: round, from: sight.position });
    if (!this.bodies.isComplete) return false;
    const drawings = [...this.drawBodies(lamps, movers, sight, own), ...this.drawRound(lamps, sight, new Set(round))];
    const around = going.length > 0 ? sight.position : '';
    const key = [shapes, around, table.keyOf(lamps.length * (most + 1), lamps.length * (most + FACES))].join(' ');
    if (key === this.made || drawings.length === 0) return true;
    this.made = key;
    const { side, columns } = this.tiling;
    const tiles = lamps.length * (most + (going.length > 0 ? FACES : 0));
    this.map.make(MAP_WIDTH, Math.ceil(tiles / columns) * side, drawings);
    return true;
  }

  /** Whether all samples that the last map needs are on the GPU. */
  get isComplete(): boolean {
    return this.bodies.isComplete;
  }

  dispose(): void {
    this.map.dispose();
    this.bodies.dispose();
  }

  private drawBodies(
    lamps: readonly KnownLamp[],
    movers: readonly Mover[],
    sight: Sight,
    own: ReadonlySet<Body>,
  ): readonly Drawing[] {
    const { most } = this;
    const prepare = (): void => {
      this.round.value = 0;
      this.bodies.showOnly(own);
    };
    return lamps.flatMap((lamp, slot) => {
      const drawn = movers.filter((mover, k) => this.setBody(lamp, mover, sight, slot * most + k));
      return drawn.length > 0 ? [{ layer: lamps.length * (most + 1) + slot * most, prepare }] : [];
    });
  }

  /** Whether a body has a tile for a lamp. */
  private setBody(lamp: KnownLamp, mover: Mover, sight: Sight, tile: number): boolean {
    const { body, beta, offset, ahead } = mover;
    if (lamp.lamp.motion.kind === 'static' && isAlwaysThere(body)) return false;
    const from = lampFrom(lamp, { offset, ahead }, sight);
    const { side } = this.tiling;
    const radius = body.radius + mover.drift;
    const layer = ballLayer(addScaled(from.offset, beta, -from.ahead), radius, { side, cell: this.map.cell });
    if (!layer) return false;
    const centre = addScaled(centreOf(mover), normalize(layer.source), -lift(mover));
    const [x, y] = middleOf(this.tiling, tile);
    const ball = [...centre, radius, ...beta, 0];
    const seen = pointTexels({ ...layer, source: add(centre, layer.source) }, x, y);
    this.table.set(tile, [...seen, ...ball]);
    this.table.set(this.lamps * (this.most + 1) + tile, [...pointTexels(layer, x, y), ...ball]);
    return true;
  }

  private drawRound(lamps: readonly KnownLamp[], sight: Sight, round: ReadonlySet<Body>): readonly Drawing[] {
    const { table, tiling, most, map, radius } = this;
    const prepare = (): void => {
      this.round.value = 1;
      this.bodies.showOnly(round);
    };
    if (round.size === 0) return [];
    return lamps.flatMap(({ lamp, line }, slot) => {
      if (lamp.motion.kind === 'static') return [];
      const { offset, ahead } = lampEventFor(line, sight);
      const place = { c: sight.c, radius, side: tiling.side, cell: map.cell };
      const layer = lampLayer(lamp, sight.t + ahead / sight.c, place);
      const tile = lamps.length * most + FACES * slot;
      const [faces, occluders] = [facesOf(lamp), lamps.length * (most + 1) + tile];
      const at = { receivers: lamps.length * most + slot, occluders, tile };
      setRoom(table, at, layer, { receivers: offset, occluders: offset }, faces, tiling);
      return Array.from({ length: faces }, (_, k) => ({ layer: occluders + k, prepare }));
    });
  }
}

/** A lamp when it sent out what meets an event, from that event. */
const lampFrom = ({ line }: KnownLamp, { offset, ahead }: RelativeEvent, sight: Sight): RelativeEvent =>
  lampEventFor(line, { ...sight, t: sight.t + ahead / sight.c, position: add(sight.position, offset) });
