import type { Accessor, Animation, Buffer, Document, Node as GltfNode } from '@gltf-transform/core';
import { msg } from '../../../messages/message.ts';
import { isStatic, sampleTimes } from '../../../scene/motion/motion.ts';
import type { Motion, SampledMotion, Scene } from '../../../scene/types.ts';
import type { DiagnosticLog } from '../../diagnostics/diagnosticLog.ts';
import { exportPoses, orientationYUp, vectorYUp } from '../../write/exportMotion.ts';

type KeyedProperty = 'translation' | 'rotation' | 'scale' | 'weights';
const TYPES = { translation: 'VEC3', rotation: 'VEC4', scale: 'VEC3', weights: 'SCALAR' } as const;

/** Keys of glTF are f32 and not before 0: the scene's times, moved where they are, and those that f32 tells apart. */
export class AnimationWriter {
  private readonly document: Document;
  private readonly buffer: Buffer;
  private readonly scene: Scene;
  /** How much later all is [s]. */
  readonly shift: number;
  private made: Animation | undefined;
  private readonly times = new Map<string, Accessor>();

  constructor(document: Document, buffer: Buffer, scene: Scene, losses: DiagnosticLog) {
    this.document = document;
    this.buffer = buffer;
    this.scene = scene;
    const { objects, cameras, lights } = scene;
    const motions = [...objects, ...cameras, ...lights].flatMap((x) => ('motion' in x ? [x.motion] : []));
    const startOf = (motion: Motion): number => {
      const times = sampleTimes(motion);
      return times ? times[0] : isStatic(motion) ? 0 : scene.startTime;
    };
    const starts = motions.map(startOf);
    this.shift = -starts.reduce((a, b) => Math.min(a, b), 0);
    if (this.shift > 0)
      losses.add('info', 'convert.times', '', msg`all times are ${this.shift} s later: glTF has none before 0`);
  }

  addPoses(node: GltfNode, motion: SampledMotion): void {
    const poses = exportPoses(motion);
    this.addKeys(node, motion.times, {
      translation: poses.map(({ position }) => vectorYUp(this.scene, position)),
      rotation: poses.map(({ orientation }) => orientationYUp(this.scene, orientation)),
    });
  }

  /** At each time one morph target alone counts, at the first none: between times the points move straight. */
  addWeights(node: GltfNode, motion: { readonly times: Float64Array }): void {
    const targets = motion.times.length - 1;
    const weights = Array.from(motion.times, (_, key) =>
      Array.from({ length: targets }, (_, i) => (i + 1 === key ? 1 : 0)),
    );
    this.addKeys(node, motion.times, { weights });
  }

  /** Values of a node at rising times [s], linear between them; what is the same at all times is left out. */
  addKeys(
    node: GltfNode,
    allTimes: ArrayLike<number>,
    values: Partial<Record<KeyedProperty, readonly (readonly number[])[]>>,
  ): void {
    const { keys, times } = this.keysOf(allTimes);
    for (const [path, all] of Object.entries(values) as [KeyedProperty, readonly (readonly number[])[]][]) {
      if (!all.some((value) => value.some((x, i) => x !== all[0][i]))) continue;
      const output = this.values(
        TYPES[path],
        keys.flatMap((i) => all[i]),
      );
      this.channel(node, path, times(), output);
    }
  }

  /** The keys that f32 tells apart; equal times are one accessor. */
  private keysOf(all: ArrayLike<number>): { keys: number[]; times: () => Accessor } {
    const rounded = Float32Array.from(all, (t) => t + this.shift);
    const keys = [...rounded.keys()].filter((i) => i === 0 || rounded[i] > rounded[i - 1]);
    const kept = keys.map((i) => rounded[i]);
    const name = kept.join(' ');
    const times = (): Accessor => {
      const known = this.times.get(name) ?? this.values('SCALAR', kept);
      this.times.set(name, known);
      return known;
    };
    return { keys, times };
  }

  private values(type: 'SCALAR' | 'VEC3' | 'VEC4', numbers: readonly number[]): Accessor {
    return this.document.createAccessor().setType(type).setArray(Float32Array.from(numbers)).setBuffer(this.buffer);
  }

  private channel(node: GltfNode, path: KeyedProperty, times: Accessor, output: Accessor): void {
    this.made ??= this.document.createAnimation('Motion');
    const sampler = this.document.createAnimationSampler().setInput(times).setOutput(output).setInterpolation('LINEAR');
    const channel = this.document.createAnimationChannel().setTargetNode(node).setTargetPath(path).setSampler(sampler);
    this.made.addSampler(sampler).addChannel(channel);
  }
}
