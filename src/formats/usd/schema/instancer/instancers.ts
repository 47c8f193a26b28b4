import * as mat4 from '../../../../math/mat4.ts';
import type { Vec3 } from '../../../../math/vec3.ts';
import { msg } from '../../../../messages/message.ts';
import { commonLifetimes } from '../../../../scene/motion/lifetimes.ts';
import type { Lifetime } from '../../../../scene/types.ts';
import { report } from '../../diagnostics.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import { metadataNumber, primAt } from '../../layer/query.ts';
import type { StageContext } from '../context.ts';
import { poseTimeOf, type SlowlightAttributes } from '../slowlightAttributes.ts';
import { nestedTransform, ROOT_TRANSFORM, type StageTransform } from '../transforms/stageTransform.ts';
import { type InstanceColor, instanceColors } from './instanceColors.ts';
import { type ExtrapolationRange, instanceTransform } from './instancePaths.ts';
import { type PointInstance, type PointInstances, pointInstancesOf } from './pointInstances.ts';
import type { PlacedInstancer, Prototype, UnplacedGprim } from './prototype.ts';

/** What an instance inherits from its instancers. */
export interface InstanceContext {
  readonly transform: StageTransform;
  readonly slowlight: SlowlightAttributes;
  /** When it exists, apart from what `slowlight` says [s]. */
  readonly lives: readonly Lifetime[];
  readonly color: Vec3 | undefined;
  /** Constant velocity in the stage's axes [units/s]; undefined if the transform describes the motion. */
  readonly velocity: Vec3 | undefined;
}

/** Services of the stage reader for instancers. */
export interface InstancerHost {
  /** Reads the subtree of a prim, relative to its parent. */
  prototype(prim: PrimSpec): Promise<Prototype>;
  /** Adds an object to the scene. */
  addInstance(part: UnplacedGprim, path: string, setting: InstanceContext): void;
  /** Number of objects that can still be added. */
  remainingObjects(): number;
}

/** Expands the point instancers of a stage: every instance becomes objects that share the prototype's meshes. */
export class Instancers {
  private readonly context: StageContext;
  private readonly reader: InstancerHost;
  private readonly range: ExtrapolationRange;
  private readonly populations = new Map<PrimSpec, PointInstances>();
  private readonly colors = new Map<PrimSpec, InstanceColor>();
  private readonly subtrees = new Map<string, Promise<Prototype | undefined>>();
  private readonly sizes = new Map<PrimSpec, number>();

  constructor(context: StageContext, reader: InstancerHost) {
    const end = metadataNumber(context.layer.metadata, 'endTimeCode') ?? context.startCode;
    this.context = context;
    this.reader = reader;
    this.range = { start: context.startCode, end };
  }

  /** Adds all instances of an instancer that is not within a prototype. */
  async expand(site: PlacedInstancer): Promise<void> {
    const size = await this.sizeOf(site.prim, new Set());
    const room = this.reader.remainingObjects();
    if (size > room) {
      const message = msg`its instances would be ${size.toPrecision(3)} objects, and a scene has room for ${room} more; it is left out`;
      report(this.context, 'warning', 'usd.too-many-instances', site.prim.path, message);
      return;
    }
    const around = {
      transform: ROOT_TRANSFORM,
      slowlight: {},
      lives: site.lives,
      color: undefined,
      velocity: undefined,
    };
    await this.draw(site, site.prim.path, { ...around, slowlight: site.slowlight }, new Set());
  }

  /** Number of objects of an instancer, nested instancers included. */
  private async sizeOf(prim: PrimSpec, within: Set<PrimSpec>): Promise<number> {
    const cached = this.sizes.get(prim);
    if (cached !== undefined) return cached;
    if (within.has(prim)) {
      const message = msg`it is in one of its own prototypes, which would go on for ever; it is left out there`;
      report(this.context, 'warning', 'usd.instancer', prim.path, message);
      return 0;
    }
    within.add(prim);
    const { instances, prototypes } = this.pointInstances(prim);
    const each = new Array<number>(prototypes.length).fill(0);
    for (const { prototype } of instances) each[prototype]++;
    let size = 0;
    for (const [i, path] of prototypes.entries()) {
      const subtree = each[i] > 0 ? await this.prototype(prim, path) : undefined;
      let own = (subtree?.gprims ?? []).reduce((sum, { lives }) => sum + lives.length, 0);
      for (const nested of subtree?.instancers ?? []) own += await this.sizeOf(nested.prim, within);
      size += each[i] * own;
    }
    within.delete(prim);
    this.sizes.set(prim, size);
    return size;
  }

  /** `path`: prefix of the objects' paths; `around`: inherited context without the site's own transform; `within`: the enclosing instancers. */
  private async draw(
    site: PlacedInstancer,
    path: string,
    around: InstanceContext,
    within: ReadonlySet<PrimSpec>,
  ): Promise<void> {
    const { prim } = site;
    if (within.has(prim)) return;
    const inside = new Set([...within, prim]);
    const population = this.pointInstances(prim);
    const colorOf = this.colorOf(prim, population);
    const frame = nestedTransform(around.transform, site.transform);
    for (const instance of population.instances) {
      const subtree = await this.prototype(prim, population.prototypes[instance.prototype]);
      if (!subtree) continue;
      if (this.reader.remainingObjects() <= 0) return;
      const own = this.instanceContext(population, instance, {
        ...around,
        transform: frame,
        color: colorOf(instance) ?? around.color,
      });
      await this.drawInstance(subtree, `${path}[${instance.label}]`, own, inside);
    }
  }

  private async drawInstance(
    subtree: Prototype,
    path: string,
    setting: InstanceContext,
    within: ReadonlySet<PrimSpec>,
  ): Promise<void> {
    const named = (prim: string): string => `${path}${prim.slice(subtree.parentPath.length)}`;
    const directed = (directions: SlowlightAttributes): InstanceContext => ({
      ...setting,
      slowlight: { ...setting.slowlight, ...directions },
    });
    for (const part of subtree.gprims) this.reader.addInstance(part, named(part.path), directed(part.slowlight));
    for (const nested of subtree.instancers)
      await this.draw(
        nested,
        named(nested.prim.path),
        { ...directed(nested.slowlight), lives: commonLifetimes(setting.lives, nested.lives) },
        within,
      );
  }

  private instanceContext(
    population: PointInstances,
    instance: PointInstance,
    around: InstanceContext,
  ): InstanceContext {
    const { codesPerSecond } = this.context;
    const life = { birth: instance.birth / codesPerSecond, death: instance.death / codesPerSecond };
    const lives = commonLifetimes(around.lives, [life]);
    const isStill = around.transform.times.length === 0;
    const [{ index, count }] = instance.indexRuns;
    const isDirected = poseTimeOf(around.slowlight) !== undefined;
    const rate =
      isStill && !around.velocity && !isDirected ? population.transforms.constantVelocity(index, count) : undefined;
    const matrix = around.transform.matrixAt(0);
    const frame = nestedTransform(around.transform, this.instanceTransform(population, instance, rate !== undefined));
    const drift = rate ? mat4.transformVector(matrix, rate) : around.velocity;
    return { ...around, transform: frame, lives, velocity: drift };
  }

  /** An instance with a constant velocity has its transform of time code 0. */
  private instanceTransform(population: PointInstances, instance: PointInstance, drifts: boolean): StageTransform {
    return instanceTransform(population, instance, drifts ? { start: 0, end: 0 } : this.range);
  }

  private pointInstances(prim: PrimSpec): PointInstances {
    const instances = this.populations.get(prim) ?? pointInstancesOf(this.context, prim);
    this.populations.set(prim, instances);
    return instances;
  }

  private colorOf(prim: PrimSpec, population: PointInstances): InstanceColor {
    const color = this.colors.get(prim) ?? instanceColors(this.context, prim, population);
    this.colors.set(prim, color);
    return color;
  }

  private prototype(prim: PrimSpec, path: string): Promise<Prototype | undefined> {
    const subtree = this.subtrees.get(path) ?? this.readPrototype(prim, path);
    this.subtrees.set(path, subtree);
    return subtree;
  }

  private async readPrototype(prim: PrimSpec, path: string): Promise<Prototype | undefined> {
    const prototype = primAt(this.context.layer, path);
    if (prototype) return this.reader.prototype(prototype);
    const message = msg`its prototype <${path}> is not in the stage; its instances are left out`;
    report(this.context, 'warning', 'usd.instancer', prim.path, message);
    return undefined;
  }
}
