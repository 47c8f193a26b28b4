import { Matrix4, PerspectiveCamera, Quaternion } from 'three/webgpu';
import { toMatrix } from '../math/quat.ts';
import { gamma } from '../physics/boost.ts';
import type { RenderSettings, ViewPoint } from '../scene/view.ts';
import { frustumSides } from './cull.ts';
import { FAR, NEAR } from './depth.ts';
import type { Subject } from './plate.ts';
import type { SamplePlace } from './samplePlaces.ts';
import type { SceneUpload } from './sceneUpload.ts';
import type { Sight } from './sight.ts';
import { makeUniforms, type Uniforms } from './uniforms.ts';
import type { Projection } from './vertexStage.ts';

/** A scene that stands ready to be drawn, with the eye that sees it. */
export interface Staged extends Subject {
  readonly view: ViewPoint;
  readonly sight: Sight;
  /** By body. */
  readonly seen: readonly boolean[];
}

interface Size {
  readonly width: number;
  readonly height: number;
}

/** Puts scenes in their places for a picture, and tells all passes of the eye. */
export class Staging {
  readonly uniforms: Uniforms = makeUniforms();
  readonly camera = new PerspectiveCamera();

  constructor() {
    this.camera.near = NEAR;
    this.camera.far = FAR;
  }

  /** Puts everything in its place; undefined where samples of it are still to come. `ready` is told before the edges are cut. */
  stage(
    upload: SceneUpload,
    view: ViewPoint,
    settings: RenderSettings,
    size: Size,
    ready = () => {},
  ): Staged | undefined {
    const projection = projectionOf(settings);
    const sight = sightOf(view, settings, projection);
    this.look({ upload, settings, projection, view, sight }, size);
    const seen = upload.frame.fill(upload.bodies, sight, this.gaze(view, projection), projection.event === 'newton');
    if (!upload.frame.isComplete) return undefined;
    if (settings.shadows && !upload.shadows.update(sight)) return undefined;
    ready();
    const staged = { upload, settings, projection, view, sight, seen };
    this.cut(staged, size);
    upload.environment.update(sight, settings.colors);
    upload.stars?.update(view, settings, size.width, size.height);
    return staged;
  }

  /** Everything that is the same for all samples of a picture. */
  look({ view, sight, settings, projection, upload }: Omit<Staged, 'seen'>, { width, height }: Size): void {
    const { uniforms, camera } = this;
    const tanY = Math.tan(view.fovY / 2);
    const luminous = settings.view === 'light-cone' ? 1 : 0;
    const aspect = width / height;
    uniforms.halfTangents.value.set(tanY * aspect, tanY);
    uniforms.u.value.set(...sight.u);
    uniforms.gamma.value = gamma(sight.u);
    uniforms.iterations.value = settings.iterations;
    uniforms.damping.value = settings.damping;
    uniforms.onLightCone.value = projection.event === 'emission' ? 1 : 0;
    uniforms.boosted.value = projection.place === 'apparent' ? 1 : 0;
    uniforms.lightTravels.value = settings.view === 'light-cone' && settings.lightDelay ? 1 : 0;
    uniforms.boostLight.value = luminous;
    uniforms.dopplerMix.value = luminous * settings.dopplerMix;
    uniforms.beaming.value = luminous * settings.beaming;
    uniforms.exposure.value = settings.exposure;
    uniforms.secondsPerMetre.value = 1 / sight.c;
    uniforms.orientation.value.fromArray([...toMatrix(view.orientation)]).transpose();
    lookAtGround(uniforms, view, upload);
    camera.fov = (view.fovY * 180) / Math.PI;
    camera.aspect = aspect;
    camera.quaternion.copy(new Quaternion(...view.orientation));
    camera.matrixWorld.copy(new Matrix4().makeRotationFromQuaternion(camera.quaternion));
    camera.updateMatrixWorld();
  }

  /** Moves the picture so that samples are at this place of their pixels. */
  jitter([dx, dy]: SamplePlace, { width, height }: Size): void {
    this.camera.setViewOffset(width, height, dx, dy, width, height);
    this.camera.updateProjectionMatrix();
    this.uniforms.jitter.value.set((2 * dx) / width, (-2 * dy) / height);
  }

  private gaze({ orientation }: ViewPoint, { place }: Projection) {
    const { x, y } = this.uniforms.halfTangents.value;
    return { sides: frustumSides(orientation, x, y), boosted: place === 'apparent' };
  }

  /** Cuts the batches in which something may be seen, as this picture needs it, and sorts the transparent ones from far to near. */
  private cut({ upload, view: { orientation }, sight, projection, seen }: Staged, { height }: Size): void {
    const { drawables, frame, refiner } = upload;
    const { x: tanX, y: tanY } = this.uniforms.halfTangents.value;
    const look = { sight, projection, orientation, tanX, tanY, focal: height / (2 * tanY) };
    refiner.show(look, ({ bodies }) => bodies.some(({ id }) => seen[id - 1]));
    for (const { batch, mesh } of drawables)
      if (batch.transparent) mesh.renderOrder = -Math.min(...batch.bodies.map(({ id }) => frame.distance(id)));
  }
}

export function projectionOf({ view, lightDelay, aberration, solver }: RenderSettings): Projection {
  if (view === 'simultaneity') return { event: 'slice', place: 'contracted' };
  if (view === 'galilean') return { event: 'now', place: 'plain' };
  const event = lightDelay ? (solver === 'newton' ? 'newton' : 'emission') : 'now';
  return { event, place: aberration ? 'apparent' : 'plain' };
}

function sightOf({ t, position, u }: ViewPoint, { speedOfLight }: RenderSettings, { event }: Projection): Sight {
  const surface = event === 'slice' || event === 'now' ? event : 'past-light-cone';
  return { t, position, u, c: speedOfLight, surface };
}

/** The ground is the plane of the two axes that do not point up, at height 0; its grid is as fine as the scene's size asks. */
function lookAtGround(uniforms: Uniforms, { position }: ViewPoint, { scene, radius }: SceneUpload): void {
  const step = 10 ** Math.floor(Math.log10(Math.max(radius, 1e-6) / 15));
  const [up, north] = scene.upAxis === 'Y' ? [1, 2] : [2, 1];
  const wrap = (x: number) => x - 10 * step * Math.floor(x / (10 * step));
  uniforms.zenith.value.set(0, up === 1 ? 1 : 0, up === 2 ? 1 : 0);
  uniforms.gridNorth.value.set(0, north === 1 ? 1 : 0, north === 2 ? 1 : 0);
  uniforms.gridStep.value = step;
  uniforms.ground.value.set(position[up], wrap(position[0]), wrap(position[north]));
}
