import type { Layer, PrimSpec } from '../layer/layer.ts';

/** Placement times allowed in every scene, and additionally per sample that its layers contain. */
const FREE_SAMPLES = 2 ** 18;
const SAMPLES_PER_AUTHORED = 2;

/** Number of ops beyond which a placement counts more. */
const COMMON_COST = 32;

/** Times that are probed closely in every scene. */
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
 * Limits the number of placement times of all objects of a scene together: each sample of a parent moves everything below
 * it, so that a small file can request any number. Requests are granted until little is left; then each object that may
 * still come gets an equal part, a power of two, so that objects which move together have the same times.
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

  /** Whether the intervals between so many times may be probed closely. */
  canProbeClosely(times: number): boolean {
    this.probes -= times;
    if (this.probes <= 0) this.count();
    return this.probes > 0;
  }

  /** How many of `requested` times an object gets whose placement takes `cost` ops per time; at least two. */
  take(requested: number, cost = 1): number {
    const each = Math.max(1, cost / COMMON_COST);
    return Math.max(2, Math.min(requested, Math.floor(this.taken(requested * each) / each)));
  }

  private taken(requested: number): number {
    if (!this.isShared && requested > this.left / 4) {
      this.count();
      this.isShared = true;
    }
    this.placedPrims--;
    const granted = this.isShared ? Math.min(requested, this.share()) : requested;
    this.left -= granted;
    return granted;
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
