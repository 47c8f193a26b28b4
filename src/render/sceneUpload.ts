import { Scene as ThreeScene } from 'three/webgpu';
import { sceneNightSky } from '../scene/lights/sceneLights.ts';
import { deforms, pointSamples } from '../scene/motion/motion.ts';
import type { ColorMode } from '../scene/settings/settings.ts';
import { isBlended, isStreamed } from '../scene/streaming/samplePoints.ts';
import type { SampledPointsMotion, Scene } from '../scene/types.ts';
import { HalfAtlas } from '../shaders/tables/halfAtlas.ts';
import { type DrawCall, disposeDrawCall, makeDrawCall } from './gbuffer/drawCall.ts';
import { MATERIAL_TEXELS, materialTexels } from './gbuffer/surface.ts';
import { type Batch, isPiece, layerKey } from './geometry/batches.ts';
import type { Body } from './geometry/bodies.ts';
import { ObjectTableWriter } from './geometry/objectTables.ts';
import type { Observation } from './geometry/observation.ts';
import { BlendStore } from './geometry/pointSamples/blendStore.ts';
import { PointStore } from './geometry/pointSamples/pointStore.ts';
import { SampleLoader } from './geometry/pointSamples/sampleLoader.ts';
import { ReleasedPieces } from './geometry/releasedPieces.ts';
import { indexedVertex } from './geometry/vertexInput.ts';
import type { Gpu } from './gpu/device.ts';
import { FloatTable, type TablePart } from './gpu/floatTable.ts';
import type { FrameUniforms } from './gpu/frameUniforms.ts';
import { textureKey } from './gpu/textures.ts';
import type { LayeredScene } from './layers/layeredScene.ts';
import { Environment } from './lights/environment.ts';
import type { SceneBuffers } from './sceneBuffers.ts';
import type { SceneParts } from './sceneParts.ts';
import type { RendererOptions } from './settings.ts';
import type { StarPoints } from './shading/starPoints.ts';
import { SHADOW_DETAILS } from './shadows/shadowDetail.ts';
import { ShadowMaps } from './shadows/shadowMaps.ts';
import { Tessellator } from './tessellation/tessellator.ts';

let uploads = 0;

/** A scene on the GPU for one G-buffer: geometry, tables, lights and shadow maps. */
export class SceneUpload {
  /** Serial number, unique among uploads. */
  readonly serial = uploads++;
  /** Shared with other uploads of the scene; released by who gave them. */
  readonly buffers: SceneBuffers;
  /** First one for every batch, then those of their patches, as they are created. */
  readonly drawCalls: DrawCall[] = [];
  readonly tessellator: Tessellator;
  readonly environment: Environment;
  readonly stars: StarPoints | undefined;
  /** Whether any material emits its own colour. */
  readonly hasUnlit: boolean;
  readonly objectWriter: ObjectTableWriter;
  readonly shadows: ShadowMaps;
  /** Draws materials with layers; absent if there are none. */
  readonly layered: LayeredScene | undefined;
  readonly opaque = new ThreeScene();
  readonly transparent = new ThreeScene();
  private readonly objects = new FloatTable(256);
  private readonly samples = new FloatTable(1024);
  /** Texels of materials and lights, which fragment shaders read. */
  private readonly table = new FloatTable(256);
  readonly atlas = new HalfAtlas();
  private readonly materials: TablePart;
  private readonly points = new Map<number, PointStore | BlendStore>();
  private sampleLoader: SampleLoader | undefined;
  /** Draw calls of pieces that take turns. */
  private readonly pieces: ReleasedPieces<DrawCall>;
  /** By what shaders read: pieces without textures of their own share their materials, which are expensive to compile. */
  private readonly pieceMaterials = new Map<string, DrawCall['materials']>();

  /** `parts`: those that the scene needs, at least. */
  constructor(
    buffers: SceneBuffers,
    uniforms: FrameUniforms,
    gpu: Gpu,
    options: RendererOptions,
    { Layered, StarPoints: Stars, DomeTexture }: SceneParts,
  ) {
    const { scene } = buffers;
    this.buffers = buffers;
    this.hasUnlit = scene.materials.some(({ unlit }) => unlit);
    this.materials = this.table.part(scene.materials.length * MATERIAL_TEXELS);
    this.layered = Layered && new Layered(scene, this.table, buffers.textures);
    this.environment = new Environment(scene, this.table, this.atlas, DomeTexture);
    const nightSky = sceneNightSky(scene);
    this.stars = nightSky && Stars && new Stars(nightSky, uniforms, gpu);
    this.objectWriter = new ObjectTableWriter({ objects: this.objects, samples: this.samples, points: this.points });
    // Several lives of one thing have one motion.
    const stores = new Map<SampledPointsMotion, PointStore | BlendStore>();
    for (const { id, object } of this.bodies) {
      const samples = pointSamples(object.motion);
      if (!samples) continue;
      const store = stores.get(samples) ?? this.pointStore(samples, object.mesh.normals, gpu, options);
      stores.set(samples, store);
      this.points.set(id, store);
    }
    this.fillMaterials();
    for (const batch of buffers.batches) this.add(this.drawBatch(batch, uniforms));
    this.pieces = new ReleasedPieces(this.drawCalls.filter(({ batch }) => isPiece(batch)));
    // Before the tessellator changes the draw calls' geometry: shadow maps draw whole batches.
    const { bodies, points, radius } = this;
    const drawCalls = [...this.drawCalls];
    const detail = SHADOW_DETAILS[options.shadowDetail ?? 'fine'];
    const occluders = { bodies, drawCalls, materials: scene.materials, points, detail, radius };
    this.shadows = new ShadowMaps(occluders, this.environment, gpu);
    this.tessellator = new Tessellator(gpu, drawCalls, buffers.triangles, (drawCall) => this.add(drawCall), options);
  }

  get scene(): Scene {
    return this.buffers.scene;
  }

  get bodies(): readonly Body[] {
    return this.buffers.bodies;
  }

  /** Half the diagonal of the scene [m]. */
  get radius(): number {
    return this.buffers.radius;
  }

  /** Whether samples of its motions are left in files. */
  get isStreamed(): boolean {
    return this.sampleLoader !== undefined;
  }

  dispose(): void {
    this.drawCalls.forEach(disposeDrawCall);
    for (const { batch } of this.pieces.kept) this.buffers.geometry(batch).dispose();
    this.tessellator.dispose();
    this.shadows.dispose();
    this.sampleLoader?.dispose();
    for (const store of new Set(this.points.values())) store.dispose();
    for (const table of [this.objects, this.samples, this.table]) table.dispose();
    this.atlas.dispose();
    this.environment.dispose();
    this.stars?.dispose();
  }

  private pointStore(
    motion: SampledPointsMotion,
    meshNormals: Float32Array,
    gpu: Gpu,
    options: RendererOptions,
  ): PointStore | BlendStore {
    if (isBlended(motion.points)) return new BlendStore(motion.points);
    const { sampleWorker, maxPointTexels: texels } = options;
    if (!sampleWorker || !isStreamed(motion.points))
      return new PointStore(motion, meshNormals, gpu.renderer, { maxTexels: texels });
    this.sampleLoader ??= new SampleLoader(sampleWorker(), options);
    const samples = this.sampleLoader.samplesOf(motion.points);
    return new PointStore(motion, meshNormals, gpu.renderer, { maxTexels: texels, samples });
  }

  /** Frees the memory on the GPU of pieces that have not been in the picture for a while; other uploads that show one upload it again. `visible`: by body, whether it may be in this one. */
  releasePieces(visible: readonly boolean[]): void {
    for (const { batch, mesh } of this.pieces.next(({ batch }) => batch.bodies.some(({ id }) => visible[id - 1]))) {
      for (const geometry of [mesh.geometry, this.buffers.geometry(batch)]) geometry.dispose();
      for (const { id } of batch.bodies) this.points.get(id)?.release();
    }
  }

  /** Updates the lights for an observation, with their colours for a colour mode. */
  updateLights(observation: Observation, colors: ColorMode): void {
    this.environment.update(observation, colors);
    this.table.upload();
  }

  private fillMaterials(): void {
    const { materials } = this.scene;
    materials.forEach((m, i) => {
      this.materials.set(materialTexels(m), MATERIAL_TEXELS * i);
    });
  }

  private add(drawCall: DrawCall): void {
    this.drawCalls.push(drawCall);
    this.layered?.add(drawCall);
    (drawCall.batch.transparent ? this.transparent : this.opaque).add(drawCall.mesh);
  }

  private drawBatch(batch: Batch, uniforms: FrameUniforms): DrawCall {
    const points = deforms(batch) ? this.points.get(batch.bodies[0].id) : undefined;
    const colored = batch.arrays.colors !== undefined;
    const { buffers } = this;
    const instances = batch.instancing ? buffers.instances : undefined;
    const drawCall = makeDrawCall(buffers.geometry(batch), {
      batch,
      vertex: {
        kind: batch.kind,
        objects: this.objects,
        samples: this.samples,
        uniforms,
        ...(points && { points }),
        ...(instances && { instances }),
        vertex: () => indexedVertex(colored, instances),
      },
      surface: {
        materials: this.materials,
        uniforms,
        colored,
        textures: buffers.textures.ofSurface(batch.textures),
      },
    });
    if (!isPiece(batch) || points || instances) return drawCall;
    const { kind, transparent, doubleSided } = batch;
    const layered = batch.layered && layerKey(batch.layered);
    const textures = Object.values(batch.textures).map((each) =>
      'texture' in each ? [textureKey(each.texture), 'channel' in each && each.channel] : textureKey(each),
    );
    const key = [kind, transparent, doubleSided, colored, Object.keys(batch.textures), textures, layered].join(' ');
    const materials = this.pieceMaterials.get(key) ?? drawCall.materials;
    this.pieceMaterials.set(key, materials);
    return { ...drawCall, materials };
  }
}
