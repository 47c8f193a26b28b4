import { Matrix4, PerspectiveCamera, Quaternion } from 'three/webgpu';
import { toMatrix } from '../math/quat.ts';
import { gamma } from '../physics/boost.ts';
import type { Gauge } from '../scene/gauge.ts';
import type { Scene } from '../scene/types.ts';
import { type AovName, DEFAULT_SETTINGS, type RenderSettings, type ViewPoint } from '../scene/view.ts';
import type { PictureMaker } from './api.ts';
import { frustumSides } from './cull.ts';
import { FAR, NEAR } from './depth.ts';
import { type Gpu, openGpu } from './device.ts';
import { paletteOf } from './palette.ts';
import { PictureMachine } from './picture.ts';
import { type Region, readBytes, readData, readFloats, readSurfaceAt } from './readback.ts';
import { rehearse } from './rehearsal.ts';
import { gridPlaces, type SamplePlace, wanderingPlace } from './samplePlaces.ts';
import { SceneUpload } from './sceneUpload.ts';
import type { PickResult, RendererInfo, RendererOptions, Sampling } from './settings.ts';
import type { Sight } from './sight.ts';
import { makeUniforms, type Uniforms } from './uniforms.ts';
import type { Projection } from './vertexStage.ts';

/** Samples in a pixel along each side, where there is time: what pictures at rest come to. */
const FINEST = 8;
const CENTRE: SamplePlace = [0, 0];
/** Of so many samples a picture is better than one that was smoothed otherwise. */
const WORTHWHILE = 8;

/** A picture that was made, and can be drawn again. */
interface Made {
  readonly upload: SceneUpload;
  readonly projection: Projection;
  readonly settings: RenderSettings;
}

/** Makes pictures of a scene for a page, a command line or a benchmark; see api.ts. */
export class SceneRenderer implements PictureMaker {
  private readonly gpu: Gpu;
  private readonly uniforms = makeUniforms();
  private readonly machine: PictureMachine;
  private readonly camera = new PerspectiveCamera();
  private readonly toCanvas: boolean;
  private readonly options: RendererOptions;
  private upload: SceneUpload | undefined;
  /** What pictures have been drawn with, or can be at once. */
  private readonly compiled = new Set<string>();
  private preparing: Promise<void> | undefined;
  private taken: Sight | undefined;
  /** Of the last picture, and of the next one: the size changes when that is made, for a canvas of a new size is empty. */
  private size = { width: 1, height: 1 };
  private wanted = this.size;
  private made: Made | undefined;
  /** Samples of the last picture that `refine` has added. */
  private added = 0;
  /** The G-buffer and the light are those of the pixels' centres. */
  private settled = true;
  private pictures = 0;
  private drawn = { objectsDrawn: 0, milliseconds: 0 };

  static async create(options: RendererOptions = {}): Promise<SceneRenderer> {
    return new SceneRenderer(await openGpu(options), options);
  }

  private constructor(gpu: Gpu, options: RendererOptions) {
    this.gpu = gpu;
    this.options = options;
    this.toCanvas = options.canvas !== undefined;
    this.machine = new PictureMachine(gpu, this.uniforms);
    this.camera.near = NEAR;
    this.camera.far = FAR;
  }

  get info(): RendererInfo {
    const { upload, drawn, gpu } = this;
    const triangles = upload?.refiner.triangles ?? 0;
    const tolerance = upload?.refiner.toleranceReached ?? 0;
    const waiting = upload !== undefined && !(upload.frame.isComplete && upload.shadows.isComplete);
    return { backend: gpu.backend, objects: upload?.bodies.length ?? 0, triangles, tolerance, waiting, ...drawn };
  }
  get width(): number {
    return this.size.width;
  }
  get height(): number {
    return this.size.height;
  }

  async setScene(scene: Scene): Promise<void> {
    this.replace(scene, scene.hints.speedOfLight ?? DEFAULT_SETTINGS.speedOfLight);
  }

  setSize(width: number, height: number): void {
    this.wanted = { width: Math.max(1, Math.round(width)), height: Math.max(1, Math.round(height)) };
    if (!this.taken) this.resize();
  }

  private resize(): void {
    const { width, height } = this.wanted;
    if (width === this.width && height === this.height) return;
    this.size = this.wanted;
    this.gpu.renderer.setSize(width, height, false);
    this.machine.setSize(width, height);
    this.taken = undefined;
  }

  prepare(viewPoint: ViewPoint, settings: RenderSettings): Promise<void> | undefined {
    const { upload } = this;
    // With another speed of light it may be another upload's turn.
    if (upload?.speedOfLight !== settings.speedOfLight && upload?.dependsOnSpeedOfLight) return undefined;
    if (!upload || this.compiled.has(shadersOf(settings, upload))) return undefined;
    this.preparing ??= this.compile(upload, viewPoint, settings).finally(() => {
      this.preparing = undefined;
    });
    return this.preparing;
  }

  private async compile(upload: SceneUpload, viewPoint: ViewPoint, settings: RenderSettings): Promise<void> {
    const projection = projectionOf(settings);
    const stage = this.stage(upload, viewPoint, settings, projection);
    if (!stage) return;
    const draw = (): void => {
      this.machine.look = { ...settings, starry: upload.stars !== undefined };
      this.sampleAt(CENTRE, { upload, projection, settings });
      this.machine.smoothing.smoothEdges(this.machine.look);
      if (this.toCanvas) this.machine.present('canvas');
    };
    // Whatever comes of it: a shader that cannot be compiled is told of when it is to be drawn with.
    await rehearse(this.gpu.renderer, draw).finally(() => this.compiled.add(shadersOf(settings, upload)));
  }

  render(viewPoint: ViewPoint, settings: RenderSettings, sampling: Sampling = 1): void {
    const began = performance.now();
    const upload = this.uploadFor(settings.speedOfLight);
    if (!upload) return;
    const projection = projectionOf(settings);
    const stage = this.stage(upload, viewPoint, settings, projection, () => this.resize());
    if (!stage) return;
    const { sight, seen } = stage;
    this.made = { upload, projection, settings };
    this.machine.look = { ...settings, starry: upload.stars !== undefined };
    this.added = 0;
    if (settings.falseColors && sampling === 'temporal') this.drawSamples(1);
    else if (sampling === 'temporal') this.follow(viewPoint, sight, projection);
    else this.drawSamples(sampling);
    if (this.toCanvas) this.machine.present('canvas');
    this.taken = sight;
    this.drawn = { objectsDrawn: seen.filter(Boolean).length, milliseconds: performance.now() - began };
    this.compiled.add(shadersOf(settings, upload));
    if (this.toCanvas) upload.refiner.countSometimes();
  }

  /** Puts everything in its place for a picture; undefined where samples of it are still to come. */
  private stage(
    upload: SceneUpload,
    viewPoint: ViewPoint,
    settings: RenderSettings,
    projection: Projection,
    beforeCutting = () => {},
  ): { readonly sight: Sight; readonly seen: readonly boolean[] } | undefined {
    const sight = sightOf(viewPoint, settings, projection);
    this.look(viewPoint, sight, settings, projection, upload);
    const gaze = this.gaze(viewPoint, projection);
    const seen = upload.frame.fill(upload.bodies, sight, gaze, projection.event === 'newton');
    if (!upload.frame.isComplete) return undefined;
    if (settings.shadows && !upload.shadows.update(sight)) return undefined;
    beforeCutting();
    this.cut(upload, viewPoint, sight, projection, seen);
    upload.environment.update(sight, settings.colors);
    upload.stars?.update(viewPoint, settings, this.width, this.height);
    return { sight, seen };
  }

  refine(): boolean {
    const { made, machine, added } = this;
    const count = FINEST * FINEST;
    if (!made || made.settings.falseColors || !made.upload.frame.isComplete || machine.samples > 1) return false;
    if (added === count) return false;
    this.sampleAt(gridPlaces(FINEST)[added]);
    this.added = added + 1;
    machine.smoothing.add(added, count, machine.look, this.added >= WORTHWHILE);
    if (this.toCanvas) machine.present('canvas');
    return this.added < count;
  }

  /** n × n samples per pixel. */
  private drawSamples(n: number): void {
    const { machine } = this;
    machine.samples = n * n;
    for (const [i, place] of gridPlaces(n).entries()) {
      this.sampleAt(place);
      if (n === 1) machine.smoothing.smoothEdges(machine.look);
      else machine.smoothing.add(i, n * n, machine.look, true);
    }
    if (machine.look.falseColors) this.settle();
  }

  /** One sample, and what is left of the pictures before. */
  private follow(view: ViewPoint, sight: Sight, projection: Projection): void {
    const { machine } = this;
    machine.samples = 1;
    this.sampleAt(wanderingPlace(this.pictures++));
    machine.smoothing.follow(machine.look, { sight, view, projection, aspect: this.width / this.height });
  }

  /** Draws the last picture with its samples at one place of their pixels. */
  private sampleAt(place: SamplePlace, made = this.made): void {
    if (!made) return;
    const { upload, projection, settings } = made;
    this.jitter(place);
    this.machine.drawGeometry(upload, projection, this.camera);
    this.machine.drawLight(upload, projection, this.camera, settings);
    this.settled = place[0] === 0 && place[1] === 0;
  }

  /** Numbers are of the pixels' centres, and never a mean. */
  private settle(): void {
    if (!this.settled && this.made?.upload.frame.isComplete) this.sampleAt(CENTRE);
  }

  async readPixels(): Promise<Uint8Array> {
    await this.upload?.refiner.count();
    return readBytes(this.gpu, this.machine.present('screen'), this.whole());
  }

  async readAov(name: AovName): Promise<Float32Array> {
    this.settle();
    if (name !== 'beauty') return readData(this.gpu, this.machine, name, this.picture(), this.whole());
    const { target, index } = this.machine.beauty();
    return withoutAlpha(await readFloats(this.gpu, target, index, this.whole()));
  }

  async pick(x: number, y: number): Promise<PickResult | undefined> {
    const inside = x >= 0 && y >= 0 && x < this.width && y < this.height;
    const { upload, taken } = this;
    if (!inside || !upload || !taken) return undefined;
    this.settle();
    const pathOf = (id: number) => upload.bodies[id - 1].object.path;
    const [column, row] = [Math.floor(x), Math.floor(y)];
    const { target, index } = this.machine.beauty();
    const [light, surface] = await Promise.all([
      readFloats(this.gpu, target, index, { x: column, y: row, width: 1, height: 1 }),
      readSurfaceAt(this.gpu, this.machine, taken, pathOf, column, row),
    ]);
    return { light: [light[0], light[1], light[2]], ...(surface && { surface }) };
  }

  async gauge(): Promise<Gauge> {
    this.settle();
    return this.machine.measure(this.picture().c);
  }

  dispose(): void {
    this.upload?.dispose();
    this.machine.dispose();
    this.gpu.renderer.dispose();
  }

  private picture(): Sight {
    if (!this.taken) throw new Error('nothing has been rendered yet');
    return this.taken;
  }

  private whole(): Region {
    return { x: 0, y: 0, width: this.width, height: this.height };
  }

  private uploadFor(speedOfLight: number): SceneUpload | undefined {
    const { upload } = this;
    if (upload?.dependsOnSpeedOfLight && upload.speedOfLight !== speedOfLight) this.replace(upload.scene, speedOfLight);
    return this.upload;
  }

  private replace(scene: Scene, speedOfLight: number): void {
    const made = new SceneUpload(scene, speedOfLight, this.uniforms, this.gpu, this.options);
    this.made = undefined;
    if (this.upload) {
      this.machine.forget(this.upload);
      this.upload.dispose();
    }
    this.upload = made;
  }

  private gaze({ orientation }: ViewPoint, { place }: Projection) {
    const { x, y } = this.uniforms.halfTangents.value;
    return { sides: frustumSides(orientation, x, y), boosted: place === 'apparent' };
  }

  /** Everything that is the same for all samples of a picture. */
  private look(
    view: ViewPoint,
    sight: Sight,
    settings: RenderSettings,
    projection: Projection,
    upload: SceneUpload,
  ): void {
    const { uniforms, camera } = this;
    const tanY = Math.tan(view.fovY / 2);
    const luminous = settings.view === 'light-cone' ? 1 : 0;
    const aspect = this.wanted.width / this.wanted.height;
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
  private jitter([dx, dy]: SamplePlace): void {
    const { width, height } = this;
    this.camera.setViewOffset(width, height, dx, dy, width, height);
    this.camera.updateProjectionMatrix();
    this.uniforms.jitter.value.set((2 * dx) / width, (-2 * dy) / height);
  }

  /** Cuts the batches in which something may be seen, as this picture needs it, and sorts the transparent ones from far to near. */
  private cut(
    { drawables, frame, refiner }: SceneUpload,
    { orientation }: ViewPoint,
    sight: Sight,
    projection: Projection,
    seen: readonly boolean[],
  ): void {
    const { x: tanX, y: tanY } = this.uniforms.halfTangents.value;
    const look = { sight, projection, orientation, tanX, tanY, focal: this.height / (2 * tanY) };
    refiner.show(look, ({ bodies }) => bodies.some(({ id }) => seen[id - 1]));
    for (const { batch, mesh } of drawables)
      if (batch.transparent) mesh.renderOrder = -Math.min(...batch.bodies.map(({ id }) => frame.distance(id)));
  }
}

function projectionOf({ view, lightDelay, aberration, solver }: RenderSettings): Projection {
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

/** Names all the shaders that a picture takes. */
function shadersOf(settings: RenderSettings, { serial, scene }: SceneUpload): string {
  const { tone, grid, falseColors, shadows, occlusionRadius } = settings;
  const { event, place } = projectionOf(settings);
  const palette = paletteOf(settings, scene);
  return [serial, event, place, palette, shadows, occlusionRadius !== 0, tone, grid, falseColors?.kind].join(' ');
}

function withoutAlpha(rgba: Float32Array): Float32Array {
  const out = new Float32Array((rgba.length / 4) * 3);
  for (let i = 0; i < rgba.length / 4; i++) for (let k = 0; k < 3; k++) out[3 * i + k] = rgba[4 * i + k];
  return out;
}
