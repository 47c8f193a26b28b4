import { texture } from 'three/tsl';
import {
  FloatType,
  HalfFloatType,
  LinearFilter,
  type Node,
  type RenderTarget,
  type Texture,
  UnsignedByteType,
} from 'three/webgpu';
import type { RenderSettings } from '../scene/view.ts';
import type { Vec4 } from '../shaders/types.ts';
import {
  addedSample,
  antialiased,
  averaged,
  type Look as DisplayLook,
  followed,
  freshSample,
  plain,
  singleSample,
} from './display.ts';
import { EyeBefore, type Look as Seen } from './eyeBefore.ts';
import { dataTarget, type GBuffer } from './targets.ts';
import { blended, Kernel } from './temporal.ts';
import type { Uniforms } from './uniforms.ts';
import type { Projection } from './vertexStage.ts';

type Look = DisplayLook & Pick<RenderSettings, 'antialiasing'>;

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

/** How a picture comes of samples: of one as it is, with smooth edges (FXAA), as the mean of many, or with the pictures before it. */
export type Way = 'plain' | 'edges' | 'mean' | 'followed';

/** From samples of light to a picture without steps. */
export class Smoothing {
  private readonly from: Samples;
  private readonly single = filteredTarget();
  private readonly sums = [sumTarget(), sumTarget()] as const;
  private readonly fresh = [dataTarget(1, HalfFloatType), dataTarget(1, HalfFloatType)] as const;
  private readonly histories = [dataTarget(1, HalfFloatType), dataTarget(1, HalfFloatType)] as const;
  private readonly before = new EyeBefore();
  private readonly kernel = new Kernel();
  /** Which of two targets was written last. */
  private sum = 0;
  private turn = 0;
  /** What passes read of targets that take turns. */
  private readonly picture = texture(this.sums[0].textures[0]);
  private readonly light = texture(this.sums[0].textures[1]);
  private readonly mean = texture(this.sums[0].textures[0]);
  private readonly now = texture(this.fresh[0].texture);
  private readonly former = texture(this.fresh[0].texture);
  private readonly history = texture(this.histories[0].texture);
  private readonly latest = texture(this.histories[0].texture);
  private shown: Way = 'plain';

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
  take(look: Look): void {
    this.display(look);
    this.shown = look.antialiasing ? 'edges' : 'plain';
    this.before.forget();
  }

  /** Sample `index` of `count`; until it is `shown`, the picture before them stays. */
  add(index: number, count: number, look: Look, shown: boolean): void {
    const { uniforms } = this.from;
    uniforms.weight.value = 1 / count;
    uniforms.firstSample.value = index === 0 ? 1 : 0;
    this.sum = index % 2;
    this.accumulate(look);
    if (shown) this.shown = 'mean';
  }

  /** A picture of one sample, which follows those before. */
  follow(look: Look, seen: Seen): void {
    const { width, height } = this.single;
    const { x, y } = this.from.uniforms.jitter.value;
    this.kernel.place((x * width) / 2, (-y * height) / 2);
    this.before.meet(seen);
    this.turn = 1 - this.turn;
    this.blend(look, seen.projection);
    this.shown = 'followed';
  }

  present(target: RenderTarget | null): void {
    this.show(this.shown, target);
  }

  /** Runs the passes of a way, and those of more samples, and leaves what is known of pictures that were made. */
  rehearse(way: Way, look: Look, projection: Projection, target: RenderTarget | null): void {
    if (way === 'plain' || way === 'edges') this.display(look);
    if (way === 'followed') this.blend(look, projection);
    if (look.antialiasing || way === 'mean') this.accumulate(look);
    for (const each of look.antialiasing ? [way, 'mean' as const] : [way]) this.show(each, target);
  }

  /** Where the mean of the samples' light is, once all are added. */
  get lightMean(): { readonly target: RenderTarget; readonly index: number } {
    return { target: this.sums[this.sum], index: 1 };
  }

  dispose(): void {
    for (const target of this.targets) target.dispose();
  }

  private display(look: Look): void {
    const { buffer, uniforms, run } = this.from;
    const light = this.from.light();
    run(`single ${light.id} ${keyOf(look)}`, () => singleSample(light, buffer, uniforms, look), this.single);
  }

  /** The last sum, and this sample. */
  private accumulate(look: Look): void {
    const { buffer, uniforms, run } = this.from;
    const light = this.from.light();
    const { picture, light: sum } = this;
    [picture.value, sum.value] = this.sums[1 - this.sum].textures;
    const before = { picture, light: sum };
    run(
      `add ${light.id} ${keyOf(look)}`,
      () => addedSample(light, before, buffer, uniforms, look),
      this.sums[this.sum],
    );
  }

  private blend(look: Look, projection: Projection): void {
    const { buffer, uniforms, run } = this.from;
    const light = this.from.light();
    const { before, kernel, turn, now, former, history } = this;
    run(`fresh ${light.id} ${keyOf(look)}`, () => freshSample(light, buffer, uniforms, look), this.fresh[turn]);
    now.value = this.fresh[turn].texture;
    former.value = this.fresh[1 - turn].texture;
    history.value = this.histories[1 - turn].texture;
    const sources = { fresh: now, freshBefore: former, history, buffer, uniforms, before, kernel, projection };
    run(`follow ${projection.event} ${projection.place}`, () => blended(sources), this.histories[turn]);
  }

  private show(way: Way, target: RenderTarget | null): void {
    const { single, mean, latest } = this;
    const { run } = this.from;
    mean.value = this.sums[this.sum].textures[0];
    latest.value = this.histories[this.turn].texture;
    const passes: Record<Way, () => Vec4> = {
      plain: () => plain(single.texture),
      edges: () => antialiased(single.texture),
      mean: () => averaged(mean),
      followed: () => followed(latest),
    };
    run(`show ${way}`, passes[way], target);
  }

  private get targets(): readonly RenderTarget[] {
    return [this.single, ...this.sums, ...this.fresh, ...this.histories];
  }
}

const keyOf = ({ tone, grid, starry }: DisplayLook): string => `${tone} ${grid} ${starry}`;

function filteredTarget(): RenderTarget {
  const target = dataTarget(1, UnsignedByteType);
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
