import {
  FloatType,
  HalfFloatType,
  LinearFilter,
  type Node,
  type RenderTarget,
  type Texture,
  UnsignedByteType,
} from 'three/webgpu';
import {
  addedSample,
  antialiased,
  averaged,
  type Look as DisplayLook,
  followed,
  freshSample,
  singleSample,
} from './display.ts';
import { EyeBefore, type Look } from './eyeBefore.ts';
import { dataTarget, type GBuffer } from './targets.ts';
import { blended } from './temporal.ts';
import type { Uniforms } from './uniforms.ts';

/** Runs the pass of a name, made when it is first asked for. */
export type Run = (name: string, output: () => Node, target: RenderTarget | null) => void;

/** What the ways of smoothing read. */
export interface Samples {
  /** Of the sample that was drawn last. */
  readonly light: () => Texture;
  readonly buffer: GBuffer;
  readonly uniforms: Uniforms;
  readonly run: Run;
}

/** From samples of light to a picture without steps: by its edges alone (FXAA), as the mean of many samples, or with the pictures before it. */
export class Smoothing {
  private readonly from: Samples;
  private readonly single = filteredTarget(UnsignedByteType);
  private readonly sums = [sumTarget(), sumTarget()] as const;
  private readonly fresh = [dataTarget(1, HalfFloatType), dataTarget(1, HalfFloatType)] as const;
  private readonly histories = [filteredTarget(HalfFloatType), filteredTarget(HalfFloatType)] as const;
  private readonly before = new EyeBefore();
  /** Which of two targets was written last. */
  private sum = 0;
  private turn = 0;
  private shown: 'edges' | 'mean' | 'followed' = 'edges';

  constructor(from: Samples) {
    this.from = from;
  }

  setSize(width: number, height: number): void {
    for (const target of this.targets) target.setSize(width, height);
    this.before.forget();
  }

  /** The next picture has nothing to do with those before. */
  forget(): void {
    this.before.forget();
  }

  /** A picture of one sample. */
  smoothEdges(look: DisplayLook): void {
    const { buffer, uniforms, run } = this.from;
    const light = this.from.light();
    run(`single ${light.id} ${keyOf(look)}`, () => singleSample(light, buffer, uniforms, look), this.single);
    this.shown = 'edges';
    this.before.forget();
  }

  /** Sample `index` of `count`; until it is `shown`, the picture before them stays. */
  add(index: number, count: number, look: DisplayLook, shown: boolean): void {
    const { buffer, uniforms, run } = this.from;
    const light = this.from.light();
    uniforms.weight.value = 1 / count;
    uniforms.firstSample.value = index === 0 ? 1 : 0;
    const [from, to] = index % 2 === 0 ? [1, 0] : [0, 1];
    const before = { picture: this.sums[from].textures[0], light: this.sums[from].textures[1] };
    run(
      `add ${to} ${light.id} ${keyOf(look)}`,
      () => addedSample(light, before, buffer, uniforms, look),
      this.sums[to],
    );
    this.sum = to;
    if (shown) this.shown = 'mean';
  }

  /** A picture of one sample, which follows those before. */
  follow(look: DisplayLook, seen: Look): void {
    const { buffer, uniforms, run } = this.from;
    const light = this.from.light();
    const { before, turn } = this;
    const { projection } = seen;
    before.meet(seen);
    const [history, freshBefore] = [this.histories[turn].texture, this.fresh[turn].texture];
    this.turn = 1 - turn;
    const [next, fresh] = [this.histories[this.turn], this.fresh[this.turn]];
    run(`fresh ${this.turn} ${light.id} ${keyOf(look)}`, () => freshSample(light, buffer, uniforms, look), fresh);
    run(
      `follow ${this.turn} ${projection.event} ${projection.place}`,
      () => blended({ fresh: fresh.texture, freshBefore, history, buffer, uniforms, before, projection }),
      next,
    );
    this.shown = 'followed';
  }

  present(target: RenderTarget | null): void {
    const { single, sums, histories, sum, turn } = this;
    const { run } = this.from;
    if (this.shown === 'edges') run('antialiased', () => antialiased(single.texture), target);
    else if (this.shown === 'mean') run(`averaged ${sum}`, () => averaged(sums[sum].textures[0]), target);
    else run(`followed ${turn}`, () => followed(histories[turn].texture), target);
  }

  /** Where the mean of the samples' light is, once all are added. */
  get mean(): { readonly target: RenderTarget; readonly index: number } {
    return { target: this.sums[this.sum], index: 1 };
  }

  dispose(): void {
    for (const target of this.targets) target.dispose();
  }

  private get targets(): readonly RenderTarget[] {
    return [this.single, ...this.sums, ...this.fresh, ...this.histories];
  }
}

const keyOf = ({ tone, grid, starry }: DisplayLook): string => `${tone} ${grid} ${starry}`;

function filteredTarget(type: typeof UnsignedByteType | typeof HalfFloatType): RenderTarget {
  const target = dataTarget(1, type);
  target.texture.minFilter = LinearFilter;
  target.texture.magFilter = LinearFilter;
  return target;
}

function sumTarget(): RenderTarget {
  const target = dataTarget(2, FloatType);
  ['picture', 'light'].forEach((name, i) => {
    target.textures[i].name = name;
  });
  return target;
}
