import type { Layer, PrimSpec } from '../layer/layer.ts';

/** Times at which things are placed: so many for any scene, and more the more samples its layers write. */
const FREE_SAMPLES = 2 ** 18;
const SAMPLES_PER_AUTHORED = 2;

/** What takes more ops than this counts for more. */
const COMMON_COST = 32;

/** Times that are looked at closely in any scene. */
const FREE_PROBES = 2 ** 15;

/** Prim types without a transform. */
const UNPLACED_TYPES: ReadonlySet<string> = new Set([
  '',
  'Xform',
  'Scope',
  'Material',
  'Shader',
  'GeomSubset',
  'NodeGraph',
]);

/**
 * At how many times the things of a scene can be placed, all together: what is under one prim with many samples is moved
 * by each of them, so that a small file can ask for any number. They are given as they are asked for while there is plenty; of the rest
 * each thing that may still come has its share, a power of two, so that things which move together have the same times.
 */
export class SampleBudget {
  private readonly layer: Layer;
  private left = FREE_SAMPLES;
  private probes = FREE_PROBES;
  private placedPrims = 0;
  private isShared = false;
  private isCounted = false;

  constructor(layer: Layer) {
    this.layer = layer;
  }

  /** Whether what happens between so many times can be looked at closely. */
  canProbeClosely(times: number): boolean {
    this.probes -= times;
    if (this.probes <= 0) this.count();
    return this.probes > 0;
  }

  /** How many of `wanted` times one thing gets whose place takes `cost` ops each time; at least two. */
  take(wanted: number, cost = 1): number {
    const each = Math.max(1, cost / COMMON_COST);
    return Math.max(2, Math.min(wanted, Math.floor(this.taken(wanted * each) / each)));
  }

  private taken(wanted: number): number {
    if (!this.isShared && wanted > this.left / 4) {
      this.count();
      this.isShared = true;
    }
    this.placedPrims--;
    const given = this.isShared ? Math.min(wanted, this.share()) : wanted;
    this.left -= given;
    return given;
  }

  private add(samples: number): void {
    this.left += SAMPLES_PER_AUTHORED * samples;
    this.probes += samples;
  }

  private share(): number {
    const even = this.left / Math.max(1, this.placedPrims + 1);
    return 2 ** Math.max(1, Math.floor(Math.log2(Math.max(2, even))));
  }

  /** Once, and late: most scenes need not be counted. */
  private count(): void {
    if (this.isCounted) return;
    this.isCounted = true;
    for (const prim of this.layer.rootPrims.values()) this.countIn(prim);
  }

  private countIn(prim: PrimSpec): void {
    if (!UNPLACED_TYPES.has(prim.typeName)) this.placedPrims++;
    for (const property of prim.properties.values())
      if (property.kind === 'attribute') this.add(property.timeSamples?.times.length ?? 0);
    for (const child of prim.children.values()) this.countIn(child);
  }
}
