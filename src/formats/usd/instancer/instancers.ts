import * as mat4 from '../../../math/mat4.ts';
import type { Vec3 } from '../../../math/vec3.ts';
import type { Lifetime } from '../../../scene/types.ts';
import { parentOf } from '../compose/paths.ts';
import { metadataNumber, primAt, report, type StageContext, targetsOf } from '../context.ts';
import { type Frame, nestedFrame, ROOT_FRAME } from '../frame.ts';
import type { PrimSpec } from '../layer.ts';
import type { Part, Site, Subtree } from '../parts.ts';
import { type Directions, lifetimeOf, poseTimeOf } from '../slowlight.ts';
import { type ColorOf, colorsOf } from './colors.ts';
import { instanceFrame, type Range } from './paths.ts';
import { type Instance, type Population, populationOf } from './population.ts';

/** What holds an instance, or a part of it. */
export interface Setting {
  readonly frame: Frame;
  readonly directions: Directions;
  readonly lifetime: Lifetime;
  readonly color: Vec3 | undefined;
  /** [units/s] in the stage's axes: it goes on so for ever. */
  readonly drift: Vec3 | undefined;
}

/** What an instancer asks of the reader of the stage. */
export interface Reader {
  /** What is at a prim and below it, in the axes round the prim. */
  subtree(prim: PrimSpec): Promise<Subtree>;
  /** Adds an object to the scene. */
  draw(part: Part, path: string, setting: Setting): void;
  /** Objects that the scene has room for. */
  room(): number;
}

/** The point instancers of a stage: every instance of a prototype becomes objects of its own, which share their meshes. */
export class Instancers {
  private readonly context: StageContext;
  private readonly reader: Reader;
  private readonly range: Range;
  private readonly populations = new Map<PrimSpec, Population>();
  private readonly colors = new Map<PrimSpec, ColorOf>();
  private readonly subtrees = new Map<string, Promise<Subtree | undefined>>();
  private readonly sizes = new Map<PrimSpec, number>();

  constructor(context: StageContext, reader: Reader) {
    const end = metadataNumber(context.layer.metadata, 'endTimeCode') ?? context.startCode;
    this.context = context;
    this.reader = reader;
    this.range = { start: context.startCode, end };
  }

  /** Adds all that an instancer of the stage itself shows. */
  async expand(site: Site): Promise<void> {
    const size = await this.sizeOf(site.prim, new Set());
    const room = this.reader.room();
    if (size > room) {
      const message = `its instances would be ${size.toPrecision(3)} objects, and a scene has room for ${room} more; it is left out`;
      report(this.context, 'warning', 'usd.too-many-instances', site.prim.path, message);
      return;
    }
    const directions = site.directions;
    const around = { frame: ROOT_FRAME, directions: {}, lifetime: lifetimeOf({}), color: undefined, drift: undefined };
    await this.draw(site, site.prim.path, { ...around, directions }, new Set());
  }

  /** Objects that an instancer comes to, with those of instancers in its prototypes. */
  private async sizeOf(prim: PrimSpec, within: Set<PrimSpec>): Promise<number> {
    const known = this.sizes.get(prim);
    if (known !== undefined) return known;
    if (within.has(prim)) {
      const message = 'it is in one of its own prototypes, which would go on for ever; it is left out there';
      report(this.context, 'warning', 'usd.instancer', prim.path, message);
      return 0;
    }
    within.add(prim);
    const { instances, prototypes } = this.population(prim);
    const each = new Array<number>(prototypes.length).fill(0);
    for (const { prototype } of instances) each[prototype]++;
    let size = 0;
    for (const [i, path] of prototypes.entries()) {
      const subtree = each[i] > 0 ? await this.subtree(prim, path) : undefined;
      let own = subtree?.parts.length ?? 0;
      for (const nested of subtree?.instancers ?? []) own += await this.sizeOf(nested.prim, within);
      size += each[i] * own;
    }
    within.delete(prim);
    this.sizes.set(prim, size);
    return size;
  }

  /** `path`: of the instancer as its objects are called; `around`: what holds it, but for the site's own frame; `within`: the instancers that it is in. */
  private async draw(site: Site, path: string, around: Setting, within: ReadonlySet<PrimSpec>): Promise<void> {
    const { prim } = site;
    if (within.has(prim)) return;
    const inside = new Set([...within, prim]);
    const population = this.population(prim);
    const colorOf = this.colorOf(prim, population);
    const frame = nestedFrame(around.frame, site.frame);
    for (const instance of population.instances) {
      const subtree = await this.subtree(prim, population.prototypes[instance.prototype]);
      if (!subtree) continue;
      if (this.reader.room() <= 0) return;
      const own = this.settingOf(population, instance, { ...around, frame, color: colorOf(instance) ?? around.color });
      await this.drawInstance(subtree, `${path}[${instance.label}]`, own, inside);
    }
  }

  private async drawInstance(
    subtree: Subtree,
    path: string,
    setting: Setting,
    within: ReadonlySet<PrimSpec>,
  ): Promise<void> {
    const named = (prim: string): string => `${path}${prim.slice(subtree.parentPath.length)}`;
    const directed = (directions: Directions): Setting => ({
      ...setting,
      directions: { ...setting.directions, ...directions },
    });
    for (const part of subtree.parts) this.reader.draw(part, named(part.path), directed(part.directions));
    for (const nested of subtree.instancers)
      await this.draw(nested, named(nested.prim.path), directed(nested.directions), within);
  }

  private settingOf(population: Population, instance: Instance, around: Setting): Setting {
    const { codesPerSecond } = this.context;
    const birth = Math.max(around.lifetime.birth, instance.birth / codesPerSecond);
    const death = Math.min(around.lifetime.death, instance.death / codesPerSecond);
    const isStill = around.frame.times.length === 0;
    const [{ index, count }] = instance.steps;
    const isDirected = poseTimeOf(around.directions) !== undefined;
    const rate = isStill && !around.drift && !isDirected ? population.transforms.drift(index, count) : undefined;
    const matrix = around.frame.matrixAt(0);
    const frame = nestedFrame(around.frame, this.frameOf(population, instance, rate !== undefined));
    const drift = rate ? mat4.transformVector(matrix, rate) : around.drift;
    return { ...around, frame, lifetime: { birth, death }, drift };
  }

  /** Where it drifts evenly, its place at world time 0. */
  private frameOf(population: Population, instance: Instance, drifts: boolean): Frame {
    return instanceFrame(population, instance, drifts ? { start: 0, end: 0 } : this.range);
  }

  private population(prim: PrimSpec): Population {
    const known = this.populations.get(prim) ?? populationOf(this.context, prim);
    this.populations.set(prim, known);
    return known;
  }

  private colorOf(prim: PrimSpec, population: Population): ColorOf {
    const known = this.colors.get(prim) ?? colorsOf(this.context, prim, population);
    this.colors.set(prim, known);
    return known;
  }

  private subtree(prim: PrimSpec, path: string): Promise<Subtree | undefined> {
    const known = this.subtrees.get(path) ?? this.readSubtree(prim, path);
    this.subtrees.set(path, known);
    return known;
  }

  private async readSubtree(prim: PrimSpec, path: string): Promise<Subtree | undefined> {
    const prototype = primAt(this.context.layer, path);
    if (prototype) return this.reader.subtree(prototype);
    const message = `its prototype <${path}> is not in the stage; its instances are left out`;
    report(this.context, 'warning', 'usd.instancer', prim.path, message);
    return undefined;
  }
}

/** Adds the paths of the prototypes of all instancers below some prims, and of what holds those. */
export function addPrototypes(prims: ReadonlyMap<string, PrimSpec>, to: Set<string>): Set<string> {
  for (const prim of prims.values()) {
    const own = prim.typeName === 'PointInstancer' ? targetsOf(prim, 'prototypes') : [];
    for (const path of own) for (let at = path; at !== '' && !to.has(at); at = parentOf(at)) to.add(at);
    addPrototypes(prim.children, to);
  }
  return to;
}
