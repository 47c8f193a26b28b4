import { createStore, useStore } from 'zustand';
import { type PreviewTarget, previewFrameGraph } from '../../../nodes/frameGraph/previewFrameGraph.ts';
import type { GBufferSpec, ImageSpec } from '../../../nodes/socketValues.ts';
import type { InteractiveRenderer, PreviewSource } from '../../../pipelines/interactiveRenderer.ts';
import type { PreviewRequest } from '../../../render/previews.ts';
import type { FrameGraph } from '../../../scene/frameGraph/frameGraph.ts';
import type { PreviewContext } from '../../viewport/viewportRenderer.ts';
import { PICTURE_SIZE } from '../cards/cardGeometry.ts';
import { type LuminanceHistogram, luminanceHistogram } from './luminanceHistogram.ts';

/** Rendered picture of a node's result. */
export interface NodePictureData {
  readonly image: ImageData;
  readonly histogram?: LuminanceHistogram;
  /** The value that it shows. */
  readonly of: ImageSpec | GBufferSpec;
  /** The viewport's picture at the time of rendering. */
  readonly viewportPicture: PreviewContext['view'];
}

/** Images and G-buffers by the node ids of evaluations. */
type NodeImages = ReadonlyMap<string, ImageSpec | GBufferSpec>;

/** By the node ids of evaluations. */
export const nodePictures = createStore<ReadonlyMap<string, NodePictureData>>(() => new Map());
export const useNodePicture = (name: string): NodePictureData | undefined =>
  useStore(nodePictures, (pictures) => pictures.get(name));

/** Wider pictures are cropped to their center. */
const MAX_ASPECT = PICTURE_SIZE[0] / PICTURE_SIZE[1];
/**
 * Rendered pixels per CSS pixel: single frames have no antialiasing other than downsampling; fewer on a software
 * renderer.
 */
const PIXEL_DENSITY = { hardware: 3, software: 1.5 } as const;

/** Renders node pictures with the viewport's renderer, for the lifetime of that renderer. */
export class NodePictureRenderer {
  private previews: PreviewSource | undefined;
  private renderer: InteractiveRenderer | undefined;

  /** `made`: results of all nodes with pictures; `wanted`: which of them to render now. */
  async render(made: NodeImages, wanted: ReadonlySet<string>, previewContext: PreviewContext): Promise<void> {
    const { renderer, view: shown, picture, withExposure } = previewContext;
    const height = Math.round(PICTURE_SIZE[1] * PIXEL_DENSITY[previewContext.software ? 'software' : 'hardware']);
    const width = Math.round(height * Math.min(MAX_ASPECT, renderer.width / renderer.height));
    const viewportPicture = { settings: shown.settings, scenes: picture.scenes };
    const { plan: planned, places } = previewFrameGraph(made, viewportPicture, height / renderer.height);
    if (planned.passes.length === 0) return;
    const frameGraph = withExposure(planned);
    const asked = [...wanted].flatMap((name) => {
      const place = places.get(name);
      return place ? [{ name, ...previewRequests(place, frameGraph, previewContext.exposure) }] : [];
    });
    const list = [
      ...new Map(asked.flatMap(({ orders: requests }) => requests).map((order) => [requestKey(order), order])).values(),
    ];
    const drawn = await this.for(renderer)?.make(frameGraph, list, { width, height });
    if (!drawn) return;
    const previews = new Map(list.map((order, i) => [requestKey(order), drawn[i]!]));
    const next = new Map([...nodePictures.getState()].filter(([name]) => made.has(name)));
    for (const { name, orders: requests, toned } of asked) {
      const [pixels, light] = requests.map((order) => previews.get(requestKey(order)));
      next.set(name, {
        image: new ImageData(Uint8ClampedArray.from(pixels ?? []), width, height),
        of: made.get(name)!,
        viewportPicture: shown,
        ...(light && { histogram: luminanceHistogram(light, toned) }),
      });
    }
    nodePictures.setState(next, true);
  }

  private for(renderer: InteractiveRenderer): PreviewSource | undefined {
    if (!this.previews || this.renderer !== renderer) {
      this.stop();
      this.renderer = renderer;
      this.previews = renderer.createPreviews?.();
    }
    return this.previews;
  }

  stop(): void {
    this.previews?.dispose();
    this.previews = undefined;
  }
}

const requestKey = (order: PreviewRequest): string => JSON.stringify(order);

/**
 * Render requests of a node: its picture, and the luminance that its tone curve gets; `toned`: exposure of that [EV].
 */
function previewRequests(
  place: PreviewTarget,
  frameGraph: FrameGraph,
  exposure: number,
): { readonly orders: readonly PreviewRequest[]; readonly toned: number } {
  if (place.kind === 'gbuffer') return { orders: [{ kind: 'albedo', buffer: place.buffer }], toned: 0 };
  const { step, light, metered } = place;
  const image: PreviewRequest = { kind: 'image', step, ...(light && { exposure }) };
  const curve = frameGraph.passes[step];
  const toned = curve?.kind === 'tone' ? curve.exposure : 0;
  return { orders: metered === undefined ? [image] : [image, { kind: 'luminance', step: metered }], toned };
}
