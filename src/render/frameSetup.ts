import { Matrix4, PerspectiveCamera, Quaternion } from 'three/webgpu';
import { degrees } from '../math/angle.ts';
import { toMatrix } from '../math/quat.ts';
import { add, distance, type Vec3, ZERO } from '../math/vec3.ts';
import { placementOf } from '../physics/optics/placement.ts';
import { hypersurfaceOf } from '../physics/worldLines/hypersurface.ts';
import { backdropColors } from '../scene/lights/sceneLights.ts';
import type { SkyColors } from '../scene/lights/skyGradient.ts';
import { drawnFrom, toObserver } from '../scene/view/drawnFrom.ts';
import { CUBE_FACES } from '../scene/view/lenses/cubeFaces.ts';
import { isPanoramic, perspectiveOf } from '../scene/view/lenses/lenses.ts';
import { type Frustum, frustumOf, pixelsPerTangent } from '../scene/view/lenses/perspectiveLens.ts';
import type { PictureSize } from '../scene/view/pictureSize.ts';
import type { RenderSettings, ViewPoint } from '../scene/view/view.ts';
import { hypersurfaceChoice, isLuminous, VIEWS } from '../scene/views/views.ts';
import type { Capture } from './capture/capture.ts';
import type { CapturedGBufferView } from './deferredPass.ts';
import type { Batch } from './geometry/batches.ts';
import type { Body } from './geometry/bodies.ts';
import { frustumSides } from './geometry/culling.ts';
import type { Observation } from './geometry/observation.ts';
import { type SpacetimeProjection, startsAtNow, vertexSolverOf } from './geometry/vertexStage.ts';
import { FAR, NEAR } from './gpu/depth.ts';
import { type FrameUniforms, makeFrameUniforms } from './gpu/frameUniforms.ts';
import { setObserverUniforms } from './gpu/observerUniforms.ts';
import { setLensUniforms } from './lenses/lensUniforms.ts';
import type { PictureParts } from './pictureParts.ts';
import type { BoundFace, BoundRenderView, DueCapture, PictureSample } from './pictureSample.ts';
import { PIXEL_CENTER, type SamplePosition } from './post/resolve/pixelSamples.ts';
import type { SceneUpload } from './sceneUpload.ts';
import { DEPTH_WEIGHT } from './tessellation/criterion/edgeCriterion.ts';

/** Everything that drawing a G-buffer needs. */
export interface RenderView extends CapturedGBufferView {
  /** What it is drawn from. */
  readonly viewPoint: ViewPoint;
  /** From its camera to the observer [m]. */
  readonly observer: Vec3;
  /** Index of the view in its picture. */
  readonly viewIndex: number;
  /** Place among the faces of a panoramic picture, or of a capture; absent: it is none of them. */
  readonly face?: number;
  /** Whether it is one of many narrow faces. */
  readonly isStrip?: boolean;
  /** The capture that it is a face of. */
  readonly faceOf?: Capture;
  readonly observation: Observation;
}

/** The G-buffers of one view of a picture; the first is that of the picture's own settings. */
export type ViewBuffers = readonly [RenderView, ...RenderView[]];

/** `view`: the observer's. */
export function renderViewOf(
  upload: SceneUpload,
  view: ViewPoint,
  viewIndex: number,
  settings: RenderSettings,
  captureOf: () => Capture,
): RenderView {
  const viewPoint = drawnFrom(view, settings);
  const projection = spacetimeProjectionOf(settings);
  return {
    ...{ upload, viewPoint, viewIndex, settings, projection },
    observation: observationOf(viewPoint, settings),
    observer: toObserver(view, settings),
    ...(canBeCaptured(settings, projection, viewPoint) && { capture: captureOf() }),
  };
}

/** Whether it shows the past light cone of one event, from there: that is the same for all velocities. */
const canBeCaptured = (settings: RenderSettings, { event, place }: SpacetimeProjection, view: ViewPoint): boolean =>
  settings.capture !== undefined &&
  event === 'emission' &&
  (place === 'apparent' || place === 'plain') &&
  view.vantage === undefined &&
  view.lens.kind !== 'stereo' &&
  settings.outside === undefined;

/** Largest error along the line of sight over that across it: edges are measured with `DEPTH_WEIGHT` of it, and a triangle may sag twice as far as its edges. */
const MAX_DEPTH_ERROR = 2 / DEPTH_WEIGHT;

const MAX_FACES = CUBE_FACES.length;
/** The view itself, its faces, and those of its capture have a plan each. */
const PLANS_PER_VIEW = 1 + 2 * MAX_FACES;

/** Undefined for strips, which are many. */
function planIndex({ viewIndex, face, faceOf, isStrip }: RenderView): number | undefined {
  if (isStrip) return undefined;
  const place = face === undefined ? 0 : 1 + face + (faceOf ? MAX_FACES : 0);
  return PLANS_PER_VIEW * viewIndex + place;
}

/** Prepares uploaded scenes for one view at a time, and sets the uniforms and the camera that all passes read. */
export class FrameSetup {
  readonly uniforms: FrameUniforms = makeFrameUniforms();
  readonly camera = new PerspectiveCamera();
  /** The buffers that object tables, tessellation, lights and shadow maps are up to date for. */
  private prepared: ViewBuffers | undefined;

  constructor() {
    this.camera.near = NEAR;
    this.camera.far = FAR;
  }

  /**
   * Prepares the scenes of a view's G-buffers and sets the uniforms to those of the first. Returns which bodies of the first may be visible, or undefined
   * if motion samples are still being read. `ready` is called for each G-buffer after its samples are loaded and before tessellation.
   */
  prepare(buffers: ViewBuffers, size: PictureSize, ready = () => {}): readonly boolean[] | undefined {
    this.prepared = undefined;
    let visible: readonly boolean[] | undefined;
    for (const buffer of [...buffers].reverse()) {
      visible = this.prepareBuffer(buffer, size, ready);
      if (!visible) return undefined;
    }
    this.prepared = buffers;
    return visible;
  }

  isPrepared(buffers: ViewBuffers): boolean {
    return this.prepared === buffers;
  }

  /** Call after releasing uploads. */
  invalidate(): void {
    this.prepared = undefined;
  }

  /**
   * What one sample of prepared buffers is drawn with, at this position within their pixels. Each face of a panoramic picture is prepared when it is bound, since all
   * share the tables of objects and the tessellation.
   */
  sample(buffers: ViewBuffers, position: SamplePosition, size: PictureSize, parts: PictureParts): PictureSample {
    const [first, ...others] = buffers.map((view): BoundRenderView => {
      // After the faces of its capture it is prepared again.
      const wasInterrupted = view.capture?.isDue && !isPanoramic(view.viewPoint.lens);
      const bind = (): void => {
        if (wasInterrupted) this.prepareFace(view, size);
        this.setSample(view, position, size);
      };
      return { view, bind };
    });
    const captures = buffers.flatMap((view) => this.dueCaptureOf(view));
    const panoramic = buffers.find(({ viewPoint }) => isPanoramic(viewPoint.lens));
    const { camera } = this;
    const shared = { views: [first, ...others] as const, captures, camera, time: buffers[0].viewPoint.t };
    if (!panoramic) return { ...shared, faces: [] };
    const { facesOf, faceViewPoint } = parts.faces;
    const faces = facesOf(panoramic.viewPoint, size).map((face, k): BoundFace => {
      const views = buffers.map((buffer): BoundRenderView | undefined => {
        if (!isPanoramic(buffer.viewPoint.lens)) return undefined;
        const view = {
          ...buffer,
          viewPoint: faceViewPoint(buffer.viewPoint, face),
          face: k,
          isStrip: face.rect !== undefined,
        };
        const bind = (): void => {
          this.prepareFace(view, face.size);
          this.setSample(view, position, face.size);
        };
        return { view, bind };
      });
      return { face, position, views };
    });
    return { ...shared, faces };
  }

  private dueCaptureOf(view: RenderView): readonly DueCapture[] {
    const { capture, ...rest } = view;
    if (!capture?.isDue) return [];
    const { faceSize } = capture;
    const faces = CUBE_FACES.map((_, face): BoundRenderView => {
      const viewPoint = capture.faceViewPoint(view.viewPoint, face);
      const observation = { ...view.observation, u: viewPoint.u };
      const faceView: RenderView = { ...rest, viewPoint, observation, face, faceOf: capture };
      const bind = (): void => {
        this.prepareFace(faceView, faceSize);
        this.setSample(faceView, PIXEL_CENTER, faceSize);
      };
      return { view: faceView, bind };
    });
    const awaitsBetter = (): boolean =>
      CUBE_FACES.some((_, face) => view.upload.tessellator.awaitsBetter(planIndex({ ...view, face, faceOf: capture })));
    return [{ capture, faces, awaitsBetter }];
  }

  private prepareBuffer(view: RenderView, size: PictureSize, ready: () => void): readonly boolean[] | undefined {
    const { upload, viewPoint, settings, observation, capture } = view;
    this.setView(view, size);
    capture?.plan(view, size);
    const visible = this.fillTables(view, size);
    if (!upload.objectWriter.isComplete) return undefined;
    if (settings.shadows && !upload.shadows.update(observation)) return undefined;
    ready();
    upload.releasePieces(visible);
    upload.updateLights(observation, settings.colors);
    // Of others, each face has its own; and after the faces of a capture it is done again.
    if (!isPanoramic(viewPoint.lens) && !capture?.isDue) this.placeInPicture(view, visible, size);
    return visible;
  }

  /** Prepares a view, a face of a panoramic one or of a capture, for drawing where all that does not depend on the direction is prepared. */
  private prepareFace(view: RenderView, size: PictureSize): void {
    this.setView(view, size);
    this.placeInPicture(view, this.fillTables(view, size), size);
  }

  /** Returns which bodies may be in the picture. */
  private fillTables(
    { upload, viewPoint, observation, projection, capture, faceOf }: RenderView,
    size: PictureSize,
  ): readonly boolean[] {
    if (capture && !capture.isDue && capture.holdsAll(upload)) return upload.bodies.map(() => false);
    const { lens, vantage, orientation } = viewPoint;
    // Cones of directions are the observer's: from elsewhere everything may be seen; and a capture that is to be drawn needs all.
    const showsAll = vantage || isPanoramic(lens) || capture?.isDue;
    const sides = showsAll ? [] : frustumSides(orientation, frustumIn(size, viewPoint));
    const frustum = { sides, place: projection.place };
    const isDrawn = (body: Body): boolean =>
      faceOf ? faceOf.holds(body) : !capture || capture.isDue || !capture.holds(body);
    return upload.objectWriter.fill(upload.bodies, observation, frustum, startsAtNow(projection), isDrawn);
  }

  /** Tessellates for a perspective view, and places the stars in it. */
  private placeInPicture(view: RenderView, visible: readonly boolean[], size: PictureSize): void {
    const { upload, viewPoint, settings } = view;
    this.tessellate(view, visible, frustumIn(size, viewPoint), size);
    upload.stars?.update(viewPoint, settings, size.width, size.height);
  }

  /** Sets the uniforms and the camera, which all samples of a view share but for jitter. */
  setView(
    { viewPoint: view, observation, observer, settings, projection, upload }: RenderView,
    size: PictureSize,
  ): void {
    const { uniforms, camera } = this;
    const luminous = isLuminous(settings) ? 1 : 0;
    this.setLens(view, size);
    setObserverUniforms(uniforms, observation, view.vantage);
    uniforms.toObserver.value.set(...observer);
    uniforms.iterations.value = settings.iterations;
    uniforms.damping.value = settings.damping;
    uniforms.onLightCone.value = projection.event === 'emission' ? 1 : 0;
    uniforms.onShallowCone.value = projection.event === 'shallow' ? 1 : 0;
    uniforms.boosted.value = projection.place === 'apparent' ? 1 : 0;
    uniforms.lightTravels.value = hypersurfaceOf(observation).isLightCone ? 1 : 0;
    uniforms.boostLight.value = luminous;
    uniforms.dopplerMix.value = luminous * settings.dopplerMix;
    uniforms.beaming.value = luminous * settings.beaming;
    uniforms.exposure.value = settings.exposure;
    uniforms.secondsPerMetre.value = 1 / observation.c;
    uniforms.orientation.value.fromArray([...toMatrix(view.orientation)]).transpose();
    setGroundUniforms(uniforms, view, upload);
    camera.quaternion.copy(new Quaternion(...view.orientation));
    camera.matrixWorld.copy(new Matrix4().makeRotationFromQuaternion(camera.quaternion));
    camera.updateMatrixWorld();
  }

  /** Through a panoramic lens nothing is projected: its faces have the camera one after another. */
  private setLens(view: ViewPoint, size: PictureSize): void {
    const { uniforms, camera } = this;
    setLensUniforms(uniforms.lens, view.lens, size);
    if (isPanoramic(view.lens)) return;
    const { tanX, tanY, aspect, center } = frustumIn(size, view);
    uniforms.halfTangents.value.set(tanX, tanY);
    uniforms.frustumCenter.value.set(...center);
    camera.fov = degrees(view.lens.fovY);
    camera.aspect = aspect;
  }

  /** Sets the view for samples at this position within their pixels. */
  setSample(view: RenderView, position: SamplePosition, size: PictureSize): void {
    this.setView(view, size);
    this.jitter(position, size);
  }

  /** Shifts the picture of the current view so that its samples are at this position within their pixels. */
  private jitter([dx, dy]: SamplePosition, { width, height }: PictureSize): void {
    const { halfTangents, frustumCenter } = this.uniforms;
    const { x, y } = frustumCenter.value.clone().divide(halfTangents.value);
    const { aspect } = this.camera;
    this.camera.setViewOffset(width, height, dx + (x * width) / 2, dy - (y * height) / 2, width, height);
    // `setViewOffset` has set it to width / height.
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
    this.uniforms.jitter.value.set((2 * dx) / width, (-2 * dy) / height);
  }

  /** Tessellates the batches that may be visible and are not taken from a capture, and sorts the transparent ones from far to near. */
  private tessellate(renderView: RenderView, visible: readonly boolean[], frustum: Frustum, size: PictureSize): void {
    const { upload, viewPoint, face, faceOf, capture, observation, projection } = renderView;
    const { drawCalls, objectWriter, shadows, tessellator } = upload;
    const focal = pixelsPerTangent(frustum, size.width, size.height);
    const { orientation, vantage } = viewPoint;
    const view = { observation, projection, orientation, frustum, focal, ...(vantage && { vantage }) };
    const isVisible = ({ bodies }: Batch): boolean => bodies.some(({ id }) => visible[id - 1]);
    if (capture?.holdsAll(upload)) tessellator.hideAll();
    else tessellator.update(view, planIndex(renderView), isVisible, face !== undefined && face > 0);
    const drawingError = (MAX_DEPTH_ERROR * tessellator.achievedTolerance) / focal;
    if (faceOf) faceOf.drawingError = drawingError;
    shadows.allowFor(Math.max(drawingError, capture?.drawingError ?? 0));
    const placement = placementOf(projection.place, observation.coneSlope);
    const distanceOf = ({ id }: Body): number => {
      const anchor = objectWriter.anchor(id);
      return anchor ? distance(placement.position(anchor, observation.u), vantage ?? ZERO) : Number.POSITIVE_INFINITY;
    };
    for (const { batch, mesh } of drawCalls)
      if (batch.transparent) mesh.renderOrder = -Math.min(...batch.bodies.map(distanceOf));
  }
}

/** The frustum of a view point's picture of this size. Throws a RangeError if its lens has none. */
export const frustumIn = ({ width, height }: PictureSize, { lens }: ViewPoint): Frustum =>
  frustumOf(perspectiveOf(lens), width, height);

export function spacetimeProjectionOf(settings: RenderSettings): SpacetimeProjection {
  const view = VIEWS[settings.view];
  return {
    event: vertexSolverOf(view.hypersurface(settings), settings.solver),
    place: view.placement(settings),
  };
}

function observationOf({ t, position, u }: ViewPoint, settings: RenderSettings): Observation {
  return { t, position, u, c: settings.speedOfLight, ...hypersurfaceChoice(settings) };
}

/** The ground is the plane at height 0 perpendicular to the up axis; its grid step is a power of ten chosen by the scene's radius. */
function setGroundUniforms(uniforms: FrameUniforms, view: ViewPoint, { scene, radius }: SceneUpload): void {
  const position = add(view.position, view.vantage ?? ZERO);
  const step = 10 ** Math.floor(Math.log10(Math.max(radius, 1e-6) / 15));
  const [up, north] = scene.upAxis === 'Y' ? [1, 2] : [2, 1];
  const wrap = (x: number) => x - 10 * step * Math.floor(x / (10 * step));
  uniforms.zenith.value.set(0, up === 1 ? 1 : 0, up === 2 ? 1 : 0);
  setSkyColors(uniforms, backdropColors(scene));
  uniforms.gridNorth.value.set(0, north === 1 ? 1 : 0, north === 2 ? 1 : 0);
  uniforms.gridStep.value = step;
  uniforms.ground.value.set(position[up], wrap(position[0]), wrap(position[north]));
}

/** Colours of a sky as a backdrop. */
export function setSkyColors(uniforms: FrameUniforms, { zenith, horizon, ground }: SkyColors): void {
  uniforms.skyZenith.value.set(...zenith);
  uniforms.skyHorizon.value.set(...horizon);
  uniforms.skyGround.value.set(...ground);
}
