import { type PerspectiveCamera, Scene } from 'three/webgpu';
import { ZERO } from '../../math/vec3.ts';
import { captureTexels, pixelsPerRestRadian } from '../../scene/view/captureBounds.ts';
import { CUBE_FACES } from '../../scene/view/lenses/cubeFaces.ts';
import { perspective } from '../../scene/view/lenses/perspectiveLens.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { ViewPoint } from '../../scene/view/view.ts';
import { GBuffer } from '../gbuffer/gbuffer.ts';
import type { Body } from '../geometry/bodies.ts';
import type { Observation } from '../geometry/observation.ts';
import type { Gpu } from '../gpu/device.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { faceOrientation } from '../lenses/pictureFaces.ts';
import type { drawOpaque, GBufferView } from '../opaqueGeometry.ts';
import { CaptureSchedule } from './captureSchedule.ts';
import { ATLAS_GRID, CaptureWarp } from './captureWarp.ts';

const EMPTY = new Scene();
/** A capture with at most as many times the texels that a picture needs is kept for it. */
const MAX_FINENESS = 4;

/** What a capture is taken for. */
export interface CapturableView extends GBufferView {
  readonly viewPoint: ViewPoint;
  readonly observation: Observation;
}

/** Six faces of a G-buffer around an event, for observers of any velocity there. */
export class Capture {
  private readonly gpu: Gpu;
  /** All faces, in a grid. */
  private readonly atlas: GBuffer;
  private readonly warp: CaptureWarp;
  private readonly schedule = new CaptureSchedule();
  private side = 0;
  private capturable: { readonly of: GBufferView['upload']; readonly bodies: readonly Body[] } | undefined;
  /** How far its surfaces may be drawn beside those that are seen [rad]. */
  drawingError = 0;

  constructor(gpu: Gpu, uniforms: FrameUniforms) {
    this.gpu = gpu;
    this.atlas = new GBuffer(gpu.maxBytesPerSample, gpu.maxAttachments);
    this.warp = new CaptureWarp(this.atlas, uniforms);
  }

  /** Decides what the next picture takes from the capture, and whether it has to be drawn before. */
  plan({ upload, viewPoint, observation, projection, settings }: CapturableView, size: PictureSize): void {
    if (!settings.capture) return;
    const side = this.sideFor(captureTexels(settings.capture, viewPoint, size), settings.capture.texels > 0);
    this.schedule.next({
      key: `${upload.serial} ${settings.speedOfLight} ${side}`,
      event: observation,
      bodies: this.bodiesOf(upload),
      maxError:
        settings.capture.maxError /
        pixelsPerRestRadian(viewPoint, projection.place === 'apparent' ? viewPoint.u : ZERO, size),
    });
    if (this.isDue) this.setSide(side);
  }

  /** Whether its faces have to be drawn before the next picture. */
  get isDue(): boolean {
    return this.schedule.isDue;
  }

  get faceSize(): PictureSize {
    return { width: this.side, height: this.side };
  }

  /** The view point of one of its faces, which overlap by a texel at each side. */
  faceViewPoint(view: ViewPoint, face: number): ViewPoint {
    const lens = perspective(2 * Math.atan(this.side / (this.side - 2)));
    return { ...view, u: ZERO, lens, orientation: faceOrientation(CUBE_FACES[face]!) };
  }

  /** Whether the next picture takes a body from the capture. */
  holds(body: Body): boolean {
    return this.schedule.bodies.has(body);
  }

  /** Whether the next picture takes all of a scene from it. */
  holdsAll({ bodies }: GBufferView['upload']): boolean {
    return this.schedule.bodies.size === bodies.length;
  }

  /** Draws its faces, each after its `bind`; by `draw`, which all pictures need and so is not loaded with captures. `isProvisional`: whether they should be drawn again if the observer stays. */
  take(
    faces: readonly { readonly view: GBufferView; readonly bind: () => void }[],
    camera: PerspectiveCamera,
    isProvisional: () => boolean,
    draw: typeof drawOpaque,
  ): void {
    const { side, atlas } = this;
    this.clear(camera);
    faces.forEach(({ view, bind }, k) => {
      bind();
      const [x, y] = [(k % ATLAS_GRID[0]) * side, Math.floor(k / ATLAS_GRID[0]) * side];
      for (const { target } of atlas.passes) {
        target.viewport.set(x, y, side, side);
        target.scissor.copy(target.viewport);
        target.scissorTest = true;
      }
      draw(this.gpu, view, atlas, camera, true);
    });
    this.schedule.taken(isProvisional());
  }

  /** Whole attachments: WebGL clears within the scissor, WebGPU whatever that says. */
  private clear(camera: PerspectiveCamera): void {
    for (const { target } of this.atlas.passes) {
      target.viewport.set(0, 0, target.width, target.height);
      target.scissorTest = false;
      this.gpu.renderer.setRenderTarget(target);
      this.gpu.renderer.render(EMPTY, camera);
    }
  }

  /** Fills a G-buffer with what it shows, for the observer and the perspective camera of the uniforms. */
  show({ projection }: GBufferView, to: GBuffer): void {
    this.warp.run(this.gpu.renderer, to, this.side, this.schedule.moved, projection.place);
  }

  /** Forgets what it holds. */
  reset(): void {
    this.schedule.reset();
    this.capturable = undefined;
  }

  dispose(): void {
    this.atlas.dispose();
    this.warp.dispose();
  }

  /** A finer one goes on being used: resolutions of pages change while one flies. */
  private sideFor(asked: number, isFixed: boolean): number {
    return !isFixed && this.side > asked && this.side <= MAX_FINENESS * asked ? this.side : asked;
  }

  private setSide(side: number): void {
    if (side === this.side) return;
    this.side = side;
    this.atlas.setSize(ATLAS_GRID[0] * side, ATLAS_GRID[1] * side);
  }

  /** Those that it can hold: light is computed anew from what it holds, which is the front surface, without its layers. */
  private bodiesOf(upload: GBufferView['upload']): readonly Body[] {
    if (this.capturable?.of !== upload) {
      const others = upload.drawCalls.filter(({ batch }) => batch.transparent || batch.layered);
      const excluded = new Set(others.flatMap(({ batch }) => batch.bodies));
      this.capturable = { of: upload, bodies: upload.bodies.filter((body) => !excluded.has(body)) };
    }
    return this.capturable.bodies;
  }
}
