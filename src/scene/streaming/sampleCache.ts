/** Evaluates a sample of something. */
type MakeSample<P> = (points: P, k: number) => Float32Array;

/** Least recently used cache of samples. */
class SampleCache {
  private readonly samples = new Map<string, Float32Array>();
  private readonly ids = new WeakMap<object, number>();
  private lastId = 0;
  private bytesLeft: number;

  /** `budget` [bytes]. */
  constructor(budget: number) {
    this.bytesLeft = budget;
  }

  /** Evicts the least recently used samples beyond the budget, but keeps two. */
  get<P extends object>(points: P, k: number, make: MakeSample<P>): Float32Array {
    const key = `${this.idOf(make)} ${this.idOf(points)} ${k}`;
    const sample = this.samples.get(key) ?? make(points, k);
    if (!this.samples.delete(key)) this.bytesLeft -= sample.byteLength;
    this.samples.set(key, sample);
    for (const [oldest, { byteLength }] of this.samples) {
      if (this.bytesLeft >= 0 || this.samples.size <= 2) break;
      this.samples.delete(oldest);
      this.bytesLeft += byteLength;
    }
    return sample;
  }

  private idOf(thing: object): number {
    const id = this.ids.get(thing) ?? ++this.lastId;
    this.ids.set(thing, id);
    return id;
  }
}

/** Default cache size per thread for the samples of all meshes [bytes]. */
const SAMPLE_MEMORY = 128 * 2 ** 20;
let sampleCache = new SampleCache(SAMPLE_MEMORY);

/** Sets the size of this thread's sample cache [bytes] and clears it. */
export function setSampleCacheSize(bytes: number): void {
  sampleCache = new SampleCache(bytes);
}

/** Sample k as `make` evaluates it, cached: do not write to it. */
export const cachedSample = <P extends object>(points: P, k: number, make: MakeSample<P>): Float32Array =>
  sampleCache.get(points, k, make);
