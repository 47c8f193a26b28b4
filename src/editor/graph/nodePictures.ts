import { createStore, useStore } from 'zustand';
import type { GBuffer, Image } from '../../nodes/define.ts';
import { type PreviewPlace, previewPlan } from '../../nodes/previewPlan.ts';
import { type PreviewOf, Previews } from '../../render/previews.ts';
import type { SceneRenderer } from '../../render/renderer.ts';
import type { Plan } from '../../scene/plan.ts';
import type { Besides } from '../viewport/stage.ts';
import { type LightSpread, lightSpread } from './lightSpread.ts';
import { PICTURE } from './shape.ts';

/** What a node made, to be looked at. */
export interface NodePicture {
  readonly image: ImageData;
  readonly spread?: LightSpread;
  /** What it is of. */
  readonly of: Image | GBuffer;
  /** The picture that was on show when it was made. */
  readonly beside: Besides['shown'];
}

/** Images and G-buffers, by the names that evaluations give their nodes. */
type Made = ReadonlyMap<string, Image | GBuffer>;

/** By the names that evaluations give nodes. */
export const nodePictures = createStore<ReadonlyMap<string, NodePicture>>(() => new Map());
export const useNodePicture = (name: string): NodePicture | undefined =>
  useStore(nodePictures, (pictures) => pictures.get(name));

/** Wider than this a node shows the middle of the picture. */
const WIDEST = PICTURE[0] / PICTURE[1];
/** Pixels for one of the page: what is drawn once has no smooth edges but by being made smaller; fewer where the processor draws. */
const FINENESS = { hardware: 3, software: 1.5 } as const;

/** Draws nodes' pictures with the renderer of the page, as long as that lives. */
export class NodePainter {
  #previews: Previews | undefined;
  #renderer: SceneRenderer | undefined;

  /** `made`: of all nodes that show pictures; `wanted`: of which they are to be drawn now. */
  async paint(made: Made, wanted: ReadonlySet<string>, besides: Besides): Promise<void> {
    const { renderer, shown, picture, exposed } = besides;
    const height = Math.round(PICTURE[1] * FINENESS[besides.software ? 'software' : 'hardware']);
    const width = Math.round(height * Math.min(WIDEST, renderer.width / renderer.height));
    const beside = { settings: shown.settings, scenes: picture.scenes };
    const { plan: planned, places } = previewPlan(made, beside, height / renderer.height);
    if (planned.steps.length === 0) return;
    const plan = exposed(planned);
    const asked = [...wanted].flatMap((name) => {
      const place = places.get(name);
      return place ? [{ name, ...ordersOf(place, plan, besides.exposure) }] : [];
    });
    const list = [...new Map(asked.flatMap(({ orders }) => orders).map((order) => [keyOf(order), order])).values()];
    const drawn = await this.#for(renderer).make(plan, list, { width, height });
    if (!drawn) return;
    const previews = new Map(list.map((order, i) => [keyOf(order), drawn[i]!]));
    const next = new Map([...nodePictures.getState()].filter(([name]) => made.has(name)));
    for (const { name, orders, toned } of asked) {
      const [pixels, light] = orders.map((order) => previews.get(keyOf(order)));
      next.set(name, {
        image: new ImageData(Uint8ClampedArray.from(pixels ?? []), width, height),
        of: made.get(name)!,
        beside: shown,
        ...(light && { spread: lightSpread(light, toned) }),
      });
    }
    nodePictures.setState(next, true);
  }

  #for(renderer: SceneRenderer): Previews {
    if (!this.#previews || this.#renderer !== renderer) {
      this.stop();
      this.#renderer = renderer;
      this.#previews = new Previews(renderer);
    }
    return this.#previews;
  }

  stop(): void {
    this.#previews?.dispose();
    this.#previews = undefined;
  }
}

const keyOf = (order: PreviewOf): string => JSON.stringify(order);

/** What is to be drawn of a node: its picture, and the light that its tone curve gets; `toned`: what that is exposed by [EV]. */
function ordersOf(
  place: PreviewPlace,
  plan: Plan,
  exposure: number,
): { readonly orders: readonly PreviewOf[]; readonly toned: number } {
  if (place.kind === 'gbuffer') return { orders: [{ kind: 'albedo', buffer: place.buffer }], toned: 0 };
  const { step, light, metered } = place;
  const image: PreviewOf = { kind: 'image', step, ...(light && { exposure }) };
  const curve = plan.steps[step];
  const toned = curve?.kind === 'tone' ? curve.exposure : 0;
  return { orders: metered === undefined ? [image] : [image, { kind: 'luminance', step: metered }], toned };
}
