import { uniform } from 'three/tsl';
import { add, addScaled, normalize } from '../../../math/vec3.ts';
import { isStatic } from '../../../scene/motion/motion.ts';
import type { Float, Int } from '../../../shaders/types.ts';
import type { Body } from '../../geometry/bodies.ts';
import { intersect, type Observation, type RelativeEvent } from '../../geometry/observation.ts';
import type { Gpu } from '../../gpu/device.ts';
import { type LightEntry, lightAnchor } from '../../lights/lightTable.ts';
import { LayerTable } from '../atlas/layerTable.ts';
import { type AtlasDraw, ShadowAtlas } from '../atlas/shadowAtlas.ts';
import {
  comovingCenter,
  driftBias,
  largestCasters,
  MovingCasters,
  type ObservedCaster,
} from '../casters/movingCasters.ts';
import type { ReceiverEvent } from '../distant/parallelReceiver.ts';
import { isAlwaysStatic } from '../distant/staticDistantShadows.ts';
import type { Occluders } from '../occluders.ts';
import { faceCountOf, lightLayer, setLightTiles, tileCenter } from './lightTiles.ts';
import { CELLS_PER_TILE, isTooNear, perspectiveLayerTexels, sphereLayer } from './perspectiveLayer.ts';
import { perspectiveEdgeThreshold, perspectiveProjection, type TileGrid } from './perspectiveProjection.ts';
import {
  CASTER_TEXELS,
  castersVisibility,
  type IncomingLight,
  type PerspectiveMaps,
  surroundingsVisibility,
} from './perspectiveReceiver.ts';
import { ATLAS_WIDTH } from './staticLocalShadows.ts';

/** Fewest bodies that have tiles of their own under each light, and tiles of a light that moves. */
const MIN_TILES = 2;
const MAX_FACES = 6;

/**
 * Shadows of lights where something goes. A body that a light goes past, whichever of the two it is, has a tile of its own for that light, as it looks
 * from the event that lights the body's centre. What rests and is too large or too near for that is on six tiles round a light that moves,
 * as they are from where the light is seen to be.
 */
export class DynamicLocalShadows {
  private readonly lightCount: number;
  private readonly movingBodies: readonly Body[];
  /** Bodies that rest where some light moves. */
  private readonly staticBodies: readonly Body[];
  /** Tiles of bodies for each light. */
  private readonly maxCasters: number;
  private readonly atlas: ShadowAtlas;
  /** Layers of receivers: for each light those of its bodies, then for each light its own; then in the same order those of occluders, a light's for each of its faces. */
  private readonly table: LayerTable;
  private readonly casters: MovingCasters;
  private readonly tiles: TileGrid;
  private readonly radius: number;
  /** 1 while what is round a light is drawn. */
  private readonly drawsSurroundings = uniform(0, 'int');
  private renderedKey = '';

  constructor(occluders: Occluders, lights: readonly LightEntry[], gpu: Gpu) {
    const { bodies, detail, radius } = occluders;
    const goes = lights.some(({ light }) => !isStatic(light.motion));
    this.lightCount = lights.length;
    this.radius = radius;
    this.movingBodies = lights.length > 0 ? bodies.filter((body) => !isAlwaysStatic(body)) : [];
    this.staticBodies = goes ? bodies.filter(isAlwaysStatic) : [];
    const all = this.movingBodies.length + this.staticBodies.length;
    const share = Math.floor(detail.maxLocalCasters / Math.max(1, lights.length));
    this.maxCasters = Math.min(Math.max(MIN_TILES, share), detail.maxCasters, all);
    const side = detail.localTiles[1];
    this.tiles = { side, columns: ATLAS_WIDTH / side };
    this.atlas = new ShadowAtlas(gpu, { cell: side / CELLS_PER_TILE, threshold: perspectiveEdgeThreshold(side) });
    this.table = new LayerTable(lights.length * (2 * this.maxCasters + 1 + MAX_FACES), CASTER_TEXELS);
    this.casters = new MovingCasters(occluders);
    if (all === 0) return;
    const own = new Set([...this.movingBodies, ...this.staticBodies]);
    this.casters.addTo(this.atlas, own, perspectiveProjection(this.atlas, this.table, side), this.drawsSurroundings);
  }

  /** undefined where nothing goes; `moves`: whether the light does. */
  visibility(
    slot: Int | number,
    moves: boolean,
    event: ReceiverEvent,
    beam: IncomingLight,
    taps: number,
  ): Float | undefined {
    if (this.maxCasters === 0) return undefined;
    const { atlas, table, tiles, lightCount, maxCasters: most } = this;
    const maps: PerspectiveMaps = { atlas, table, tiles, sampleCount: taps };
    const [first, own] =
      typeof slot === 'number'
        ? [slot * most, lightCount * most + slot]
        : [slot.mul(most), slot.add(lightCount * most)];
    const past = castersVisibility(maps, first, most, event, beam);
    return moves ? past.mul(surroundingsVisibility(maps, own, event, beam)) : past;
  }

  /** Makes the map that a picture needs; false where samples of a deforming mesh have still to come. */
  update(lights: readonly LightEntry[], sight: Observation): boolean {
    if (this.maxCasters === 0) return true;
    const { table, maxCasters: most, movingBodies } = this;
    for (let layer = 0; layer < lights.length * (2 * most + 1 + MAX_FACES); layer++) table.clear(layer);
    const going = lights.filter(({ light }) => !isStatic(light.motion));
    const aside = this.staticBodies.filter((body) => {
      const event = intersect(body.line, sight);
      return event && going.every((entry) => !isTooNear(lightSeenFrom(entry, event, sight).offset, body.radius));
    });
    const movers = largestCasters([...movingBodies, ...aside], sight).slice(0, most);
    const own = new Set(movers.map(({ body }) => body));
    const round = this.staticBodies.filter((body) => !own.has(body));
    const shapes = this.casters.update(movers, sight, { bodies: round, from: sight.position });
    if (!this.casters.isComplete) return false;
    const drawings = [
      ...this.drawBodies(lights, movers, sight, own),
      ...this.drawSurroundings(lights, sight, new Set(round)),
    ];
    const around = going.length > 0 ? sight.position : '';
    const key = [shapes, around, table.keyOf(lights.length * (most + 1), lights.length * (most + MAX_FACES))].join(' ');
    if (key === this.renderedKey || drawings.length === 0) return true;
    this.renderedKey = key;
    const { side, columns } = this.tiles;
    const tiles = lights.length * (most + (going.length > 0 ? MAX_FACES : 0));
    this.atlas.render(ATLAS_WIDTH, Math.ceil(tiles / columns) * side, drawings);
    return true;
  }

  /** Whether all samples that the last map needs are on the GPU. */
  get isComplete(): boolean {
    return this.casters.isComplete;
  }

  dispose(): void {
    this.atlas.dispose();
    this.casters.dispose();
  }

  private drawBodies(
    lights: readonly LightEntry[],
    movers: readonly ObservedCaster[],
    sight: Observation,
    own: ReadonlySet<Body>,
  ): readonly AtlasDraw[] {
    const { maxCasters: most } = this;
    const prepare = (): void => {
      this.drawsSurroundings.value = 0;
      this.casters.showOnly(own);
    };
    return lights.flatMap((entry, slot) => {
      const drawn = movers.filter((mover, k) => this.setBody(entry, mover, sight, slot * most + k));
      return drawn.length > 0 ? [{ layer: lights.length * (most + 1) + slot * most, prepare }] : [];
    });
  }

  /** Whether a body has a tile for a light. */
  private setBody(entry: LightEntry, mover: ObservedCaster, sight: Observation, tile: number): boolean {
    const { body, beta, offset, ahead } = mover;
    if (isStatic(entry.light.motion) && isAlwaysStatic(body)) return false;
    const from = lightSeenFrom(entry, { offset, ahead }, sight);
    const { side } = this.tiles;
    const radius = body.radius + mover.drift;
    const layer = sphereLayer(addScaled(from.offset, beta, -from.ahead), radius, { side, cell: this.atlas.cell });
    if (!layer) return false;
    const center = addScaled(comovingCenter(mover), normalize(layer.source), -driftBias(mover));
    const [x, y] = tileCenter(this.tiles, tile);
    const ball = [...center, radius, ...beta, 0];
    const seen = perspectiveLayerTexels({ ...layer, source: add(center, layer.source) }, x, y);
    this.table.set(tile, [...seen, ...ball]);
    this.table.set(this.lightCount * (this.maxCasters + 1) + tile, [...perspectiveLayerTexels(layer, x, y), ...ball]);
    return true;
  }

  private drawSurroundings(
    lights: readonly LightEntry[],
    sight: Observation,
    round: ReadonlySet<Body>,
  ): readonly AtlasDraw[] {
    const { table, tiles, maxCasters: most, atlas, radius } = this;
    const prepare = (): void => {
      this.drawsSurroundings.value = 1;
      this.casters.showOnly(round);
    };
    if (round.size === 0) return [];
    return lights.flatMap(({ light, line }, slot) => {
      if (isStatic(light.motion)) return [];
      const { offset, ahead } = lightAnchor(line, sight);
      const place = { c: sight.c, radius, side: tiles.side, cell: atlas.cell };
      const layer = lightLayer(light, sight.t + ahead / sight.c, place);
      const tile = lights.length * most + MAX_FACES * slot;
      const [faces, occluders] = [faceCountOf(light), lights.length * (most + 1) + tile];
      const at = { receivers: lights.length * most + slot, occluders, tile };
      setLightTiles(table, at, layer, { receivers: offset, occluders: offset }, faces, tiles);
      return Array.from({ length: faces }, (_, k) => ({ layer: occluders + k, prepare }));
    });
  }
}

/** A light when it sent out what meets an event, from that event. */
const lightSeenFrom = ({ line }: LightEntry, { offset, ahead }: RelativeEvent, sight: Observation): RelativeEvent =>
  lightAnchor(line, { ...sight, t: sight.t + ahead / sight.c, position: add(sight.position, offset) });
