import { int, uniform } from 'three/tsl';
import {
  FloatType,
  type Mesh,
  NearestFilter,
  NoColorSpace,
  type Node,
  PerspectiveCamera,
  RedFormat,
  RenderTarget,
  Scene as ThreeScene,
  Vector2,
} from 'three/webgpu';
import { addScaled, dot, length, normalize, scale, sub, type Vec3, ZERO } from '../../math/vec3.ts';
import { velocity } from '../../physics/boost.ts';
import { velocityAt } from '../../physics/worldLine.ts';
import type { DistantLight, Material } from '../../scene/types.ts';
import type { Float } from '../../shaders/types.ts';
import { type Body, lineOfCentre } from '../bodies.ts';
import type { Gpu } from '../device.ts';
import type { Drawable } from '../drawable.ts';
import { FloatTable } from '../floatTable.ts';
import { Frame, type FrameTables, OBJECT_TEXELS } from '../frame.ts';
import { meet, type Sight } from '../sight.ts';
import { cascadeSizes, cascades, type LitBox, litBox } from './cascades.ts';
import { type CasterSources, makeCaster } from './casters.ts';
import { lightAxes, type Tile, wayToSun } from './layer.ts';
import { LayerTable } from './layerTable.ts';
import { passingMoving, passingResting, type Receiver, type Shadowing, sliceNormal } from './receiver.ts';

/** So many suns throw shadows: the environment's first. */
const MOST_SUNS = 2;
/** So many moving bodies throw shadows: those that look largest from where the observer is, in any direction. */
const MOST_MOVERS = 16;
/** Side of a tile [texels]: of what rests, for one sun or for two, and of a moving body. */
const RESTING_SIDE = [2048, 1024] as const;
const MOVING_SIDE = 512;
const MOVERS_A_ROW = 4;
/** Smaller ones throw none: radius over distance. */
const LEAST_SIZE = 0.01;

/** Everywhere may be seen. */
const ALL_ROUND = { sides: [], boosted: false };

const throwsAlways = ({ object }: Body): boolean =>
  object.motion.kind === 'static' &&
  object.lifetime.birth === Number.NEGATIVE_INFINITY &&
  object.lifetime.death === Number.POSITIVE_INFINITY;

interface SunMaps {
  /** Towards it, unit. */
  readonly direction: Vec3;
  readonly box: LitBox | undefined;
  readonly cascades: number;
  /** Layers of its cascades for receivers, for occluders (measured from the box's centre), and of moving bodies. */
  readonly first: number;
  readonly firstCaster: number;
  readonly firstMover: number;
}

/**
 * Which sunlight things hold back from each other, in retarded time. What rests is on maps that are made anew only where the observer has gone on;
 * every moving body has its own, in coordinates that move with it: there the light's way is straight, and one projection is right for the events
 * of all receivers, whenever they are. Bodies that turn, deform or accelerate are taken as they are at the event of their centre.
 */
export class ShadowMaps implements Shadowing {
  private readonly gpu: Gpu;
  private readonly movers: readonly Body[];
  private readonly suns: readonly SunMaps[];
  private readonly layers: LayerTable;
  private readonly slots = new FloatTable(64);
  private readonly tables = { resting: frameTables(), moving: frameTables() };
  private readonly frames: { readonly moving: Frame };
  private readonly restingMap: RenderTarget;
  private readonly movingMap: RenderTarget;
  private readonly restingScene = new ThreeScene();
  private readonly movingScene = new ThreeScene();
  private readonly casters: { readonly mesh: Mesh; readonly bodies: readonly Body[] }[] = [];
  private readonly camera = new PerspectiveCamera();
  private readonly origin: Vec3;
  private readonly at = {
    layer: uniform(0, 'int'),
    firstMover: uniform(0, 'int'),
    movers: uniform(0, 'int'),
    size: uniform(new Vector2(1, 1)),
  };
  private made = '';

  constructor(
    bodies: readonly Body[],
    drawables: readonly Drawable[],
    materials: readonly Material[],
    suns: readonly DistantLight[],
    points: FrameTables['points'],
    gpu: Gpu,
  ) {
    this.gpu = gpu;
    const resting = bodies.filter(throwsAlways);
    this.movers = bodies.filter((body) => !throwsAlways(body));
    this.suns = sunMaps(
      suns.slice(0, MOST_SUNS).map(({ direction }) => normalize(scale(direction, -1))),
      resting,
    );
    this.origin = this.suns[0]?.box?.centre ?? ZERO;
    const { resting: tables, moving } = this.tables;
    for (const table of [tables.objects, moving.objects]) table.reserve(bodies.length * OBJECT_TEXELS);
    this.slots.reserve(bodies.length);
    this.layers = new LayerTable(layerCount(this.suns));
    this.frames = { moving: new Frame({ ...moving, points }) };
    const still: Sight = { t: 0, position: this.origin, u: ZERO, c: 1, surface: 'now' };
    new Frame({ ...tables, points }).fill(resting, still, ALL_ROUND, false);
    this.restingMap = heightMap();
    this.movingMap = heightMap();
    this.addCasters(drawables, materials);
  }

  share(sun: number | undefined, receiver: Receiver): Float | undefined {
    const maps = sun === undefined ? undefined : this.suns[sun];
    if (!maps) return undefined;
    const event = { dx: receiver.dx, time: receiver.time, normal: sliceNormal(receiver).toVar() };
    const { layers, movingMap, restingMap } = this;
    const still = maps.box && passingResting(restingMap.texture, layers, maps.first, maps.cascades, event);
    if (this.movers.length === 0) return still;
    const moving = passingMoving(movingMap.texture, layers, int(maps.firstMover), this.at.movers, event);
    return still ? still.mul(moving) : moving;
  }

  /** Makes the maps that a picture needs; false where samples of a deforming mesh have still to come. */
  update(sight: Sight): boolean {
    if (this.suns.length === 0) return true;
    this.placeResting(sight);
    const shown = this.placeMoving(sight);
    if (!this.isComplete) return false;
    this.gpu.renderer.setMRT(null);
    this.drawResting();
    this.drawMoving(shown);
    return true;
  }

  /** Whether all samples that the last maps need are on the GPU. */
  get isComplete(): boolean {
    return this.frames.moving.isComplete;
  }

  dispose(): void {
    for (const scene of [this.restingScene, this.movingScene])
      for (const { geometry, material } of scene.children as Mesh[]) {
        geometry.dispose();
        for (const each of [material].flat()) each.dispose();
      }
    this.restingMap.dispose();
    this.movingMap.dispose();
    const { resting, moving } = this.tables;
    for (const table of [resting.objects, resting.samples, moving.objects, moving.samples]) table.dispose();
    this.slots.dispose();
  }

  private addCasters(drawables: readonly Drawable[], materials: readonly Material[]): void {
    const { layers, at, slots } = this;
    const common = { layers, size: at.size, depthOf: depthOf(this.gpu) };
    const onTile: CasterSources = { ...common, ...this.tables.resting, layerOf: () => at.layer };
    const onOwn: CasterSources = {
      ...common,
      ...this.tables.moving,
      layerOf: (object) => {
        const slot: Node<'int'> = int(slots.texel(int(object)).x).toVar();
        return slot.lessThan(int(0)).select(int(-1), slot.add(at.firstMover));
      },
    };
    for (const drawable of drawables) {
      const { bodies, transparent } = drawable.batch;
      if (transparent) continue;
      if (bodies.some(throwsAlways)) this.restingScene.add(makeCaster(drawable, onTile, materials));
      const moving = bodies.filter((body) => !throwsAlways(body));
      if (moving.length === 0) continue;
      const mesh = makeCaster(drawable, onOwn, materials);
      this.movingScene.add(mesh);
      this.casters.push({ mesh, bodies: moving });
    }
  }

  private placeResting({ position }: Sight): void {
    this.suns.forEach(({ box, first, firstCaster, cascades: count }, sun) => {
      if (!box) return;
      const side = this.restingSide;
      const tiles = Array.from({ length: count }, (_, k): Tile => ({ x: k * side, y: sun * side, size: side }));
      cascades(box, position, tiles).forEach((layer, k) => {
        this.layers.set(first + k, { ...layer, centre: sub(layer.centre, position) });
        this.layers.set(firstCaster + k, { ...layer, centre: sub(layer.centre, this.origin) });
      });
    });
  }

  private get restingSide(): number {
    return RESTING_SIDE[Math.min(this.suns.length, RESTING_SIDE.length) - 1];
  }

  /** The bodies whose maps are to be drawn. */
  private placeMoving(sight: Sight): readonly Body[] {
    const shown = largest(this.movers, sight);
    if (this.movers.length === 0) return [];
    this.slots.values.fill(-1);
    this.frames.moving.fill(
      shown.map(({ body }) => body),
      sight,
      ALL_ROUND,
      false,
    );
    shown.forEach(({ body, offset, ahead }, slot) => {
      this.slots.values[4 * (body.id - 1)] = slot;
      const v = velocityAt(lineOfCentre(body, sight.c), sight.t + ahead / sight.c, sight.c);
      const beta = scale(v, 1 / sight.c);
      this.suns.forEach(({ direction, firstMover }, sun) => {
        this.layers.set(firstMover + slot, {
          axes: lightAxes(wayToSun(direction, beta, timePerMetre(sight, direction))),
          beta,
          centre: addScaled(offset, beta, -ahead),
          half: body.radius * (1 + 8 / MOVING_SIDE),
          depth: body.radius * 1.01,
          tile: tileOfMover(slot, sun, this.moverRows),
        });
      });
    });
    this.slots.upload();
    this.at.movers.value = shown.length;
    return shown.map(({ body }) => body);
  }

  private get moverRows(): number {
    return Math.ceil(Math.min(MOST_MOVERS, this.movers.length) / MOVERS_A_ROW);
  }

  private drawResting(): void {
    const key = this.suns.map(({ firstCaster, cascades }) => this.layers.keyOf(firstCaster, cascades)).join();
    if (key === this.made || this.restingScene.children.length === 0) return;
    this.made = key;
    const most = Math.max(...this.suns.map(({ cascades }) => cascades));
    this.open(this.restingMap, most * this.restingSide, this.suns.length * this.restingSide);
    for (const { firstCaster, cascades } of this.suns)
      for (let k = 0; k < cascades; k++) {
        this.at.layer.value = firstCaster + k;
        this.draw(this.restingScene);
      }
    this.close();
  }

  private drawMoving(shown: readonly Body[]): void {
    if (shown.length === 0) return;
    const ids = new Set(shown.map(({ id }) => id));
    for (const { mesh, bodies } of this.casters) mesh.visible = bodies.some(({ id }) => ids.has(id));
    this.open(this.movingMap, MOVERS_A_ROW * MOVING_SIDE, this.suns.length * this.moverRows * MOVING_SIDE);
    for (const { firstMover } of this.suns) {
      this.at.firstMover.value = firstMover;
      this.draw(this.movingScene);
    }
    this.close();
  }

  private open(target: RenderTarget, width: number, height: number): void {
    target.setSize(width, height);
    this.at.size.value.set(width, height);
    this.gpu.renderer.setRenderTarget(target);
    this.gpu.renderer.autoClear = true;
  }

  /** Later drawings add to the first. */
  private draw(scene: ThreeScene): void {
    this.gpu.renderer.render(scene, this.camera);
    this.gpu.renderer.autoClear = false;
  }

  private close(): void {
    this.gpu.renderer.autoClear = true;
  }
}

const frameTables = () => ({ objects: new FloatTable(256), samples: new FloatTable(1024) });

function sunMaps(directions: readonly Vec3[], resting: readonly Body[]): readonly SunMaps[] {
  const boxes = directions.map((direction) => litBox(resting, lightAxes(direction)));
  const counts = boxes.map((box) => (box ? cascadeSizes(box).length : 0));
  const cascadesOfAll = counts.reduce((sum, n) => sum + n, 0);
  return directions.map((direction, sun) => {
    const first = counts.slice(0, sun).reduce((sum, n) => sum + n, 0);
    return {
      direction,
      box: boxes[sun],
      cascades: counts[sun],
      first,
      firstCaster: cascadesOfAll + first,
      firstMover: 2 * cascadesOfAll + sun * MOST_MOVERS,
    };
  });
}

const layerCount = (suns: readonly SunMaps[]): number =>
  suns.reduce((sum, { cascades }) => sum + 2 * cascades + MOST_MOVERS, 0);

const tileOfMover = (slot: number, sun: number, rows: number): Tile => ({
  x: (slot % MOVERS_A_ROW) * MOVING_SIDE,
  y: (sun * rows + Math.floor(slot / MOVERS_A_ROW)) * MOVING_SIDE,
  size: MOVING_SIDE,
});

/** How time goes on along a ray to the sun: into the past, or in the one moment that is looked at. */
const timePerMetre = ({ surface, u }: Sight, direction: Vec3): number =>
  surface === 'past-light-cone' ? -1 : surface === 'slice' ? dot(velocity(u), direction) : 0;

/** The largest moving bodies that are there at all, with the events of their centres. */
function largest(movers: readonly Body[], sight: Sight) {
  return movers
    .flatMap((body) => {
      const event = meet(lineOfCentre(body, sight.c), sight);
      const { birth, death } = body.object.lifetime;
      if (!event || !(sight.c * (birth - sight.t) <= event.ahead && event.ahead <= sight.c * (death - sight.t)))
        return [];
      const size = body.radius / Math.max(length(event.offset) - body.radius, 1e-3 * body.radius);
      return size > LEAST_SIZE ? [{ body, ...event, size }] : [];
    })
    .sort((a, b) => b.size - a.size)
    .slice(0, MOST_MOVERS);
}

/** Nearer to the sun is nearer, as the backend and its depth buffer count. */
function depthOf({ backend, renderer }: Gpu): CasterSources['depthOf'] {
  if (renderer.reversedDepthBuffer) return (height) => height;
  return backend === 'webgl' ? (height) => height.mul(-2).add(1) : (height) => height.oneMinus();
}

const heightMap = (): RenderTarget =>
  new RenderTarget(1, 1, {
    type: FloatType,
    format: RedFormat,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
    depthBuffer: true,
    colorSpace: NoColorSpace,
  });
