import { uniform } from 'three/tsl';
import { add, addScaled, normalize } from '../../../math/vec3.ts';
import { isStatic } from '../../../scene/motion/motion.ts';
import type { Float, Int } from '../../../shaders/types.ts';
import { type Body, isSolvedPerVertex } from '../../geometry/bodies.ts';
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

/** Fewest tiles of bodies per light. */
const MIN_TILES = 2;
const MAX_FACES = 6;

/**
 * Shadows where the light or the occluder moves. A body has a tile of its own for each light that moves relative to it, showing it as seen from the emission
 * event of the light that meets the body's centre. Bodies at rest that are too large or too near for that are drawn on the six tiles round a moving light,
 * from the place where the light is seen.
 */
export class DynamicLocalShadows {
  private readonly lightCount: number;
  private readonly movingBodies: readonly Body[];
  /** Bodies at rest, if some light moves; otherwise empty. */
  private readonly staticBodies: readonly Body[];
  /** Number of body tiles per light. */
  private readonly maxCasters: number;
  private readonly atlas: ShadowAtlas;
  /**
   * The layers of receivers: for each light those of its bodies, then one per light for its surroundings; then in the same order the layers of occluders,
   * with one per face for a light's surroundings.
   */
  private readonly table: LayerTable;
  private readonly casters: MovingCasters;
  private readonly tiles: TileGrid;
  private readonly radius: number;
  /** 1 while the surroundings of a light are drawn. */
  private readonly drawsSurroundings = uniform(0, 'int');
  private renderedKey = '';

  constructor(occluders: Occluders, lights: readonly LightEntry[], gpu: Gpu) {
    const { bodies, detail, radius } = occluders;
    const anyLightMoves = lights.some(({ light }) => !isStatic(light.motion));
    this.lightCount = lights.length;
    this.radius = radius;
    this.movingBodies = lights.length > 0 ? bodies.filter((body) => !isAlwaysStatic(body)) : [];
    this.staticBodies = anyLightMoves ? bodies.filter(isAlwaysStatic) : [];
    const all = this.movingBodies.length + this.staticBodies.length;
    const castersPerLight = Math.floor(detail.maxLocalCasters / Math.max(1, lights.length));
    this.maxCasters = Math.min(Math.max(MIN_TILES, castersPerLight), detail.maxCasters, all);
    const side = detail.localTiles[1];
    this.tiles = { side, columns: ATLAS_WIDTH / side };
    this.atlas = new ShadowAtlas(gpu, { cell: side / CELLS_PER_TILE, threshold: perspectiveEdgeThreshold(side) });
    this.table = new LayerTable(lights.length * (2 * this.maxCasters + 1 + MAX_FACES), CASTER_TEXELS);
    this.casters = new MovingCasters(occluders, gpu);
    if (all === 0) return;
    const casterBodies = new Set([...this.movingBodies, ...this.staticBodies]);
    this.casters.addTo(
      this.atlas,
      casterBodies,
      perspectiveProjection(this.atlas, this.table, side),
      this.drawsSurroundings,
    );
  }

  /** Returns undefined if nothing moves; `moves`: whether the light does. */
  visibility(
    slot: Int | number,
    moves: boolean,
    event: ReceiverEvent,
    incoming: IncomingLight,
    sampleCount: number,
  ): Float | undefined {
    if (this.maxCasters === 0) return undefined;
    const { atlas, table, tiles, lightCount, maxCasters } = this;
    const maps: PerspectiveMaps = { atlas, table, tiles, sampleCount };
    const [first, surroundings] =
      typeof slot === 'number'
        ? [slot * maxCasters, lightCount * maxCasters + slot]
        : [slot.mul(maxCasters), slot.add(lightCount * maxCasters)];
    const casters = castersVisibility(maps, first, maxCasters, event, incoming);
    return moves ? casters.mul(surroundingsVisibility(maps, surroundings, event, incoming)) : casters;
  }

  /** Updates the map for a picture. Returns false if samples of a deforming mesh are not loaded yet. */
  update(lights: readonly LightEntry[], observation: Observation): boolean {
    if (this.maxCasters === 0) return true;
    const { table, maxCasters, movingBodies } = this;
    for (let layer = 0; layer < lights.length * (2 * maxCasters + 1 + MAX_FACES); layer++) table.clear(layer);
    const movingLights = lights.filter(({ light }) => !isStatic(light.motion));
    const separable = this.staticBodies.filter((body) => {
      const event = intersect(body.line, observation);
      return (
        event && movingLights.every((entry) => !isTooNear(lightSeenFrom(entry, event, observation).offset, body.radius))
      );
    });
    const movers = largestCasters([...movingBodies, ...separable], observation).slice(0, maxCasters);
    const ownBodies = new Set(movers.map(({ body }) => body));
    const surroundingBodies = this.staticBodies.filter((body) => !ownBodies.has(body));
    const shapes = this.casters.update(movers, observation, { bodies: surroundingBodies, from: observation.position });
    if (!this.casters.isComplete) return false;
    const draws = [
      ...this.drawBodies(lights, movers, observation, ownBodies),
      ...this.drawSurroundings(lights, observation, new Set(surroundingBodies)),
    ];
    const origin = movingLights.length > 0 ? observation.position : '';
    const key = [
      shapes,
      origin,
      table.keyOf(lights.length * (maxCasters + 1), lights.length * (maxCasters + MAX_FACES)),
    ].join(' ');
    if (key === this.renderedKey || draws.length === 0) return true;
    this.renderedKey = key;
    const { side, columns } = this.tiles;
    const tiles = lights.length * (maxCasters + (movingLights.length > 0 ? MAX_FACES : 0));
    this.atlas.render(ATLAS_WIDTH, Math.ceil(tiles / columns) * side, draws);
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
    observation: Observation,
    ownBodies: ReadonlySet<Body>,
  ): readonly AtlasDraw[] {
    const { maxCasters } = this;
    const prepare = (): void => {
      this.drawsSurroundings.value = 0;
      this.casters.showOnly(ownBodies);
    };
    return lights.flatMap((entry, slot) => {
      const drawn = movers.filter((mover, k) => this.setBody(entry, mover, observation, slot * maxCasters + k));
      return drawn.length > 0 ? [{ layer: lights.length * (maxCasters + 1) + slot * maxCasters, prepare }] : [];
    });
  }

  /** Sets the layers of a body's tile for a light; returns false if it has none. */
  private setBody(entry: LightEntry, mover: ObservedCaster, observation: Observation, tile: number): boolean {
    const { body, beta, offset, ahead } = mover;
    if (isStatic(entry.light.motion) && isAlwaysStatic(body)) return false;
    const lightEvent = lightSeenFrom(entry, { offset, ahead }, observation);
    const { side } = this.tiles;
    const radius = body.radius + mover.drift;
    const layer = sphereLayer(addScaled(lightEvent.offset, beta, -lightEvent.ahead), radius, {
      side,
      cell: this.atlas.cell,
    });
    if (!layer) return false;
    const center = addScaled(comovingCenter(mover), normalize(layer.source), -driftBias(mover));
    const [x, y] = tileCenter(this.tiles, tile);
    const sphere = [...center, radius, ...beta, Number(isSolvedPerVertex(body.object.motion))];
    const receiver = perspectiveLayerTexels({ ...layer, source: add(center, layer.source) }, x, y);
    this.table.set(tile, [...receiver, ...sphere]);
    this.table.set(this.lightCount * (this.maxCasters + 1) + tile, [...perspectiveLayerTexels(layer, x, y), ...sphere]);
    return true;
  }

  private drawSurroundings(
    lights: readonly LightEntry[],
    observation: Observation,
    surroundingBodies: ReadonlySet<Body>,
  ): readonly AtlasDraw[] {
    const { table, tiles, maxCasters, atlas, radius } = this;
    const prepare = (): void => {
      this.drawsSurroundings.value = 1;
      this.casters.showOnly(surroundingBodies);
    };
    if (surroundingBodies.size === 0) return [];
    return lights.flatMap(({ light, line }, slot) => {
      if (isStatic(light.motion)) return [];
      const { offset, ahead } = lightAnchor(line, observation);
      const place = { c: observation.c, radius, side: tiles.side, cell: atlas.cell };
      const layer = lightLayer(light, observation.t + ahead / observation.c, place);
      const tile = lights.length * maxCasters + MAX_FACES * slot;
      const [faces, occluders] = [faceCountOf(light), lights.length * (maxCasters + 1) + tile];
      const at = { receivers: lights.length * maxCasters + slot, occluders, tile };
      setLightTiles(table, at, layer, { receivers: offset, occluders: offset }, faces, tiles);
      return Array.from({ length: faces }, (_, k) => ({ layer: occluders + k, prepare }));
    });
  }
}

/** A light at its emission event that meets an event, relative to the latter. */
const lightSeenFrom = (
  { line }: LightEntry,
  { offset, ahead }: RelativeEvent,
  observation: Observation,
): RelativeEvent =>
  lightAnchor(line, {
    ...observation,
    t: observation.t + ahead / observation.c,
    position: add(observation.position, offset),
  });
