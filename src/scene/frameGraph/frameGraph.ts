import type { ToneMapping } from '../../spectrum/display/toneMap.ts';
import type { FalseColorQuantity, ValueRange } from '../../spectrum/falseColor/falseColor.ts';
import type { BufferSettings } from '../settings/settings.ts';
import type { ShaderProgram } from '../shaderText/program.ts';
import type { CaptureSettings } from '../view/capture.ts';
import type { OutsideCamera } from '../view/outsideCamera.ts';
import type { EffectId, FogColor, MixMode } from './effects.ts';
import type { StillPixels } from './still.ts';

/*
 * A frame graph: a list of passes, each of which makes an image from those before it. Built by the nodes; executed by the rasterizer
 * (render/frameGraph/) and the reference (reference/post/frameGraph.ts), with the same result. Plain data.
 */

/** A G-buffer in addition to that of the picture's own settings, for the same observer. */
export interface FrameGraphBuffer extends BufferSettings {
  /** Looks at it from outside; absent: it is seen with the observer's eye. */
  readonly outside?: OutsideCamera;
  /** Takes it from a capture; absent: it is drawn. */
  readonly capture?: CaptureSettings;
  /** Index among the renderer's scenes. */
  readonly scene: number;
}

/** A user-written effect (scene/shaderText/). */
export interface CustomEffect {
  readonly text: string;
  /** The text as `readShaderText` reads it. Renderers run it, and need no parser. */
  readonly program: ShaderProgram;
}

/** A pass, with references to images and G-buffers of the given types. */
export type FrameGraphPassOf<Image, Buffer> =
  /** Shades the G-buffer: linear light. `occlusion`: with ambient occlusion. */
  | { readonly kind: 'light'; readonly buffer: Buffer; readonly shadows: boolean; readonly occlusion: boolean }
  /** A picture rendered once, for one camera at one time; fitted by `fitStill` of scene/frameGraph/still.ts. */
  | { readonly kind: 'still'; readonly still: StillPixels }
  /** Ambient occlusion as a grey image; 1 where there is no surface. `radius`: as `occlusionRadius` of the settings; 0: the default for the scene. */
  | { readonly kind: 'occlusion'; readonly buffer: Buffer; readonly radius: number }
  | {
      readonly kind: 'effect';
      readonly effect: EffectId | CustomEffect;
      /** arg1 … arg4 */
      readonly args: readonly number[];
      /** Of effects that fade distant things; absent: the effect's own. */
      readonly fogColor?: FogColor;
      readonly image: Image;
      /** What `image2` of a custom effect reads. */
      readonly second?: Image;
      readonly buffer: Buffer;
      /** Its first channel is the weight of the effect. */
      readonly mask?: Image;
    }
  | {
      readonly kind: 'mix';
      readonly mode: MixMode;
      readonly alpha: number;
      readonly below: Image;
      readonly above: Image;
      readonly mask?: Image;
    }
  /** Tone maps light to 0 … 1, still linear. Unless `metering` is manual, the metered exposure is added to `exposure` [EV]. */
  | {
      readonly kind: 'tone';
      readonly tone: ToneMapping;
      readonly exposure: number;
      readonly metering: 'automatic' | 'resting-eye' | 'manual';
      readonly image: Image;
    }
  /** Values of a G-buffer or of the light as linear colours 0 … 1. `scale`: absent until measured. */
  | {
      readonly kind: 'false-colour';
      readonly of: FalseColorQuantity;
      readonly scale?: ValueRange;
      readonly image: Image;
      readonly buffer: Buffer;
    };

/** Refers to earlier passes and to G-buffers by their indices. */
export type FrameGraphPass = FrameGraphPassOf<number, number>;

/** The image of the last pass is the light of the picture, which is then exposed and tone mapped by the settings. Equal passes occur once. */
export interface FrameGraph {
  /** G-buffers 1, 2 …; number 0 is that of the settings themselves, of the renderer's first scene. */
  readonly extraBuffers: readonly FrameGraphBuffer[];
  readonly passes: readonly FrameGraphPass[];
}

/** Limits on passes, G-buffers and stills, each of which needs one or several textures of the picture's or the still's size. */
export const MAX_PASSES = 64;
export const MAX_BUFFERS = 4;
export const MAX_STILL_IMAGES = 4;

/** The images that a pass is made from. */
export function inputImages<Image>(pass: FrameGraphPassOf<Image, unknown>): readonly Image[] {
  switch (pass.kind) {
    case 'light':
    case 'still':
    case 'occlusion':
      return [];
    case 'mix':
      return [pass.below, pass.above, ...(pass.mask === undefined ? [] : [pass.mask])];
    case 'effect':
      return [pass.image, ...[pass.second, pass.mask].filter((image) => image !== undefined)];
    default:
      return [pass.image];
  }
}

/**
 * Whether a frame graph contains tone mapping. Then the light of the picture's first G-buffer is metered for it; otherwise the graph's result is metered,
 * exposed and tone mapped.
 */
export const includesToneMapping = (frameGraph: FrameGraph | undefined): boolean =>
  frameGraph?.passes.some(({ kind }) => kind === 'tone') ?? false;

/** Settings, frame graphs or passes as text for comparison; a still is identified by its key, a user-written effect by its text. */
export const contentKey = (data: unknown): string =>
  JSON.stringify(data, (name, value: unknown) =>
    name === ('program' satisfies keyof CustomEffect) || ArrayBuffer.isView(value) ? undefined : value,
  );

/** A frame graph without its numbers: graphs of equal structure are drawn by the same shaders. */
export const frameGraphStructure = ({ extraBuffers, passes }: FrameGraph): string =>
  JSON.stringify([extraBuffers.length, passes.map(withoutNumericValues)]);

/** An effect's name, or its text. */
const idOf = (effect: EffectId | CustomEffect): string => (typeof effect === 'string' ? effect : effect.text);

function withoutNumericValues(pass: FrameGraphPass): unknown {
  switch (pass.kind) {
    case 'effect':
      return { ...pass, effect: idOf(pass.effect), args: 0, fogColor: 0 };
    case 'mix':
      return { ...pass, alpha: 0 };
    case 'tone':
      return { ...pass, exposure: 0 };
    case 'still':
      return { ...pass, still: 0 };
    case 'occlusion':
      return { ...pass, radius: 0 };
    case 'false-colour':
      return { ...pass, scale: 0 };
    default:
      return pass;
  }
}
