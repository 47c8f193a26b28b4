import { Matrix4, PerspectiveCamera, Quaternion } from 'three/webgpu';
import { degrees } from '../math/angle.ts';
import { toMatrix } from '../math/quat.ts';
import { gamma } from '../physics/lorentz/boost.ts';
import { HYPERSURFACES } from '../physics/worldLines/hypersurface.ts';
import type { RenderSettings, ViewPoint } from '../scene/view/view.ts';
import { VIEWS } from '../scene/views/views.ts';
import type { GBufferView } from './deferredPass.ts';
import { frustumSides } from './geometry/culling.ts';
import type { Observation } from './geometry/observation.ts';
import { type SpacetimeProjection, vertexSolverOf } from './geometry/vertexStage.ts';
import { FAR, NEAR } from './gpu/depth.ts';
import { type FrameUniforms, makeFrameUniforms } from './gpu/frameUniforms.ts';
import type { SamplePosition } from './post/resolve/pixelSamples.ts';
import type { SceneUpload } from './sceneUpload.ts';

/** All that a G-buffer is made of: it can be drawn again. */
export interface RenderView extends GBufferView {
  readonly viewPoint: ViewPoint;
  readonly observation: Observation;
}

export function renderViewOf(upload: SceneUpload, viewPoint: ViewPoint, settings: RenderSettings): RenderView {
  const projection = spacetimeProjectionOf(settings);
  return { upload, viewPoint, settings, projection, observation: observationOf(viewPoint, settings) };
}

/** Of a picture [px]. */
export interface PixelSize {
  readonly width: number;
  readonly height: number;
}

/** Puts scenes in their places for a picture, and tells all passes of the eye. */
export class FrameSetup {
  readonly uniforms: FrameUniforms = makeFrameUniforms();
  readonly camera = new PerspectiveCamera();

  constructor() {
    this.camera.near = NEAR;
    this.camera.far = FAR;
  }

  /**
   * Puts everything in its place; tells which bodies may be seen, or undefined where samples of them are still to come. `ready` is told before the
   * edges are cut.
   */
  prepareFrame(motif: RenderView, size: PixelSize, ready = () => {}): readonly boolean[] | undefined {
    const { upload, viewPoint, settings, observation, projection } = motif;
    this.setView(motif, size);
    const seen = upload.objectWriter.fill(
      upload.bodies,
      observation,
      this.frustum(viewPoint, projection),
      projection.event === 'newton',
    );
    if (!upload.objectWriter.isComplete) return undefined;
    if (settings.shadows && !upload.shadows.update(observation)) return undefined;
    ready();
    this.tessellate(motif, seen, size);
    upload.updateLights(observation, settings.colors);
    upload.stars?.update(viewPoint, settings, size.width, size.height);
    return seen;
  }

  /** Everything that is the same for all samples of a picture. */
  setView(
    { viewPoint: view, observation, settings, projection, upload }: RenderView,
    { width, height }: PixelSize,
  ): void {
    const { uniforms, camera } = this;
    const tanY = Math.tan(view.fovY / 2);
    const luminous = VIEWS[settings.view].luminous ? 1 : 0;
    const aspect = width / height;
    uniforms.halfTangents.value.set(tanY * aspect, tanY);
    uniforms.u.value.set(...observation.u);
    uniforms.gamma.value = gamma(observation.u);
    uniforms.iterations.value = settings.iterations;
    uniforms.damping.value = settings.damping;
    uniforms.onLightCone.value = projection.event === 'emission' ? 1 : 0;
    uniforms.boosted.value = projection.place === 'apparent' ? 1 : 0;
    uniforms.lightTravels.value = HYPERSURFACES[observation.hypersurface].isLightCone ? 1 : 0;
    uniforms.boostLight.value = luminous;
    uniforms.dopplerMix.value = luminous * settings.dopplerMix;
    uniforms.beaming.value = luminous * settings.beaming;
    uniforms.exposure.value = settings.exposure;
    uniforms.secondsPerMetre.value = 1 / observation.c;
    uniforms.orientation.value.fromArray([...toMatrix(view.orientation)]).transpose();
    setGroundUniforms(uniforms, view, upload);
    camera.fov = degrees(view.fovY);
    camera.aspect = aspect;
    camera.quaternion.copy(new Quaternion(...view.orientation));
    camera.matrixWorld.copy(new Matrix4().makeRotationFromQuaternion(camera.quaternion));
    camera.updateMatrixWorld();
  }

  /** Moves the picture so that samples are at this place of their pixels. */
  jitter([dx, dy]: SamplePosition, { width, height }: PixelSize): void {
    this.camera.setViewOffset(width, height, dx, dy, width, height);
    this.camera.updateProjectionMatrix();
    this.uniforms.jitter.value.set((2 * dx) / width, (-2 * dy) / height);
  }

  private frustum({ orientation }: ViewPoint, { place }: SpacetimeProjection) {
    const { x, y } = this.uniforms.halfTangents.value;
    return { sides: frustumSides(orientation, x, y), place };
  }

  /** Cuts the batches in which something may be seen, as this picture needs it, and sorts the transparent ones from far to near. */
  private tessellate(
    { upload, viewPoint: { orientation }, observation, projection }: RenderView,
    seen: readonly boolean[],
    { height }: PixelSize,
  ): void {
    const { drawCalls, objectWriter: frame, tessellator } = upload;
    const { x: tanX, y: tanY } = this.uniforms.halfTangents.value;
    const view = { observation, projection, orientation, tanX, tanY, focal: height / (2 * tanY) };
    tessellator.update(view, ({ bodies }) => bodies.some(({ id }) => seen[id - 1]));
    for (const { batch, mesh } of drawCalls)
      if (batch.transparent) mesh.renderOrder = -Math.min(...batch.bodies.map(({ id }) => frame.distance(id)));
  }
}

export function spacetimeProjectionOf(settings: RenderSettings): SpacetimeProjection {
  const view = VIEWS[settings.view];
  return {
    event: vertexSolverOf(view.hypersurface(settings), settings.solver),
    place: view.placement(settings),
  };
}

function observationOf({ t, position, u }: ViewPoint, settings: RenderSettings): Observation {
  const hypersurface = VIEWS[settings.view].hypersurface(settings);
  return { t, position, u, c: settings.speedOfLight, hypersurface };
}

/** The ground is the plane of the two axes that do not point up, at height 0; its grid is as fine as the scene's size asks. */
function setGroundUniforms(uniforms: FrameUniforms, { position }: ViewPoint, { scene, radius }: SceneUpload): void {
  const step = 10 ** Math.floor(Math.log10(Math.max(radius, 1e-6) / 15));
  const [up, north] = scene.upAxis === 'Y' ? [1, 2] : [2, 1];
  const wrap = (x: number) => x - 10 * step * Math.floor(x / (10 * step));
  uniforms.zenith.value.set(0, up === 1 ? 1 : 0, up === 2 ? 1 : 0);
  uniforms.gridNorth.value.set(0, north === 1 ? 1 : 0, north === 2 ? 1 : 0);
  uniforms.gridStep.value = step;
  uniforms.ground.value.set(position[up], wrap(position[0]), wrap(position[north]));
}
