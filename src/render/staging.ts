import { Matrix4, PerspectiveCamera, Quaternion } from 'three/webgpu';
import { degrees } from '../math/angle.ts';
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

/** All that a G-buffer is made of: it can be drawn again. */
export interface Motif extends Subject {
  readonly viewPoint: ViewPoint;
  readonly sight: Sight;
}

export function motifOf(upload: SceneUpload, viewPoint: ViewPoint, settings: RenderSettings): Motif {
  const projection = projectionOf(settings);
  return { upload, viewPoint, settings, projection, sight: sightOf(viewPoint, settings, projection) };
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

  /**
   * Puts everything in its place; tells which bodies may be seen, or undefined where samples of them are still to come. `ready` is told before the
   * edges are cut.
   */
  stage(motif: Motif, size: Size, ready = () => {}): readonly boolean[] | undefined {
    const { upload, viewPoint, settings, sight, projection } = motif;
    this.look(motif, size);
    const seen = upload.frame.fill(
      upload.bodies,
      sight,
      this.gaze(viewPoint, projection),
      projection.event === 'newton',
    );
    if (!upload.frame.isComplete) return undefined;
    if (settings.shadows && !upload.shadows.update(sight)) return undefined;
    ready();
    this.cut(motif, seen, size);
    upload.light(sight, settings.colors);
    upload.stars?.update(viewPoint, settings, size.width, size.height);
    return seen;
  }

  /** Everything that is the same for all samples of a picture. */
  look({ viewPoint: view, sight, settings, projection, upload }: Motif, { width, height }: Size): void {
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
    camera.fov = degrees(view.fovY);
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
  private cut(
    { upload, viewPoint: { orientation }, sight, projection }: Motif,
    seen: readonly boolean[],
    { height }: Size,
  ): void {
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
