import { Discard, Fn, float, max, mix, vec2, vec4 } from 'three/tsl';
import { Mesh, NoBlending, NodeMaterial, type Texture, Scene as ThreeScene } from 'three/webgpu';
import { isStatic } from '../../scene/motion/motion.ts';
import type { Material, Scene } from '../../scene/types.ts';
import { type DrawCall, drawOver, materialSide } from '../gbuffer/drawCall.ts';
import type { GBuffer } from '../gbuffer/gbuffer.ts';
import type { SceneTextures } from '../gbuffer/sceneTextures.ts';
import { frontNormal, readSurface, type SurfaceSources, uvDirectionsHere } from '../gbuffer/surface.ts';
import { vertexStage } from '../geometry/vertexStage.ts';
import type { FloatTable } from '../gpu/floatTable.ts';
import { texelHere } from '../gpu/fullScreenPass.ts';
import { limitLight } from '../gpu/lightRange.ts';
import { depthHere, type ForwardLighting } from '../shading/passes.ts';
import type { FuzzNodes } from './fuzz.ts';
import { type Glass, lightBehind } from './glass.ts';
import type { GroovesHere } from './grooves.ts';
import { type GlassView, type SurfaceLayers, shadeLayered } from './layeredShading.ts';
import { type LayerReader, MaterialLayerTable } from './materialLayerTable.ts';

/** What layered materials are drawn with. */
export interface LayeredPass extends ForwardLighting {
  /** Equal for passes that share their shaders. */
  readonly key: string;
  readonly buffer: GBuffer;
  readonly openness?: Texture;
}

/** A draw call, and the mesh by which it is drawn over the light. */
interface OverlayMesh {
  readonly drawCall: DrawCall;
  readonly mesh: Mesh;
}

/** Tolerance of the apparent distance at which a fragment is the one in the G-buffer. */
const SAME_DISTANCE = 1 + 1e-4;

/** Draws the surfaces of layered materials over the light of the G-buffer, which has only their base. */
export class LayeredScene {
  private readonly table: MaterialLayerTable;
  private readonly scene = new ThreeScene();
  private readonly overlays: OverlayMesh[] = [];
  private readonly readers = new Map<Material, LayerReader>();

  constructor({ materials }: Scene, table: FloatTable, textures: SceneTextures) {
    this.table = new MaterialLayerTable(materials, table, textures);
  }

  add(drawCall: DrawCall): void {
    if (!drawCall.batch.layered || drawCall.batch.transparent) return;
    const mesh = new Mesh(drawCall.mesh.geometry);
    mesh.frustumCulled = false;
    mesh.matrixAutoUpdate = false;
    this.overlays.push({ drawCall, mesh });
    this.scene.add(mesh);
  }

  /** `draw` draws over the light. */
  drawSurfaces(pass: LayeredPass, draw: (scene: ThreeScene) => void): void {
    for (const { drawCall, mesh } of this.overlays) {
      mesh.visible = drawCall.mesh.visible;
      mesh.geometry = drawCall.mesh.geometry;
      const key = `layers ${pass.key}`;
      const material = drawCall.materials.get(key) ?? this.overlayMaterial(drawCall, drawCall.batch.layered!, pass);
      drawCall.materials.set(key, material);
      mesh.material = material;
    }
    if (this.overlays.some(({ mesh }) => mesh.visible)) draw(this.scene);
  }

  private overlayMaterial(drawCall: DrawCall, like: Material, pass: LayeredPass): NodeMaterial {
    const { uniforms } = drawCall.surface;
    const { buffer, environment, pipeline, range, shadows, openness } = pass;
    const material = new NodeMaterial();
    material.name = `layers ${drawCall.batch.kind}`;
    material.vertexNode = vertexStage(drawCall.vertex, pass.projection);
    material.fragmentNode = Fn(() => {
      const layers = readLayers(this.reader(like), drawCall.surface, like);
      const surface = readSurface(drawCall.surface);
      const seen = texelHere(buffer.texture('object')).toVar();
      Discard(seen.x.notEqual(surface.object).or(surface.distance.greaterThan(seen.y.mul(SAME_DISTANCE))));
      const velocity = isStatic(drawCall.batch) ? undefined : surface.velocity;
      const lit = { ...surface, velocity, ...(openness && { openness: texelHere(openness).x.toVar() }) };
      const light = shadeLayered(lit, layers, environment, uniforms, pipeline, shadows);
      return vec4(limitLight(light, range.max), 1);
    })();
    material.side = materialSide(drawCall.batch);
    // Drawn after the opaque, in the order of three.js.
    material.blending = NoBlending;
    material.depthTest = false;
    material.depthWrite = false;
    return material;
  }

  /** The material of a transparent draw call with layers; `background`: the light of what is behind it. */
  glassMaterial(drawCall: DrawCall, pass: LayeredPass, background: Texture): NodeMaterial {
    const like = drawCall.batch.layered!;
    const { uniforms } = drawCall.surface;
    const { buffer, environment, pipeline, range, shadows, projection } = pass;
    const material = new NodeMaterial();
    material.name = `glass ${drawCall.batch.kind}`;
    material.vertexNode = vertexStage(drawCall.vertex, projection);
    material.fragmentNode = Fn(() => {
      const reader = this.reader(like);
      const layers = readLayers(reader, drawCall.surface, like);
      const surface = readSurface(drawCall.surface);
      Discard(surface.distance.greaterThan(depthHere(buffer)));
      const clear = like.transmission && {
        share: reader.number('transmission'),
        behind: (view: GlassView) =>
          lightBehind(
            surface,
            glassOf(reader, like),
            view,
            background,
            buffer.texture('object'),
            projection.place,
            pipeline,
            uniforms,
          ),
      };
      const velocity = isStatic(drawCall.batch) ? undefined : surface.velocity;
      const lit = { ...surface, velocity };
      const light = shadeLayered(lit, { ...layers, ...(clear && { clear }) }, environment, uniforms, pipeline, shadows);
      return vec4(limitLight(light, range.max), clear ? 1 : surface.color.w);
    })();
    return drawOver(material, drawCall.batch);
  }

  private reader(like: Material): LayerReader {
    const known = this.readers.get(like) ?? this.table.reader(like);
    this.readers.set(like, known);
    return known;
  }
}

function glassOf(reader: LayerReader, { volume, dispersion }: Material): Glass {
  const { z: ior, w: spread } = reader.vector(1).toVar();
  return {
    thickness: volume ? reader.vector(0).w.mul(reader.number('thickness')).toVar() : float(0),
    ior: max(ior, 1),
    attenuation: reader.vector(2).toVar(),
    ...(volume && dispersion && { dispersion: spread }),
  };
}

function filmOf(reader: LayerReader): NonNullable<SurfaceLayers['film']> {
  const { x: ior, y: thinnest, z: thickest } = reader.vector(3).toVar();
  return { factor: reader.number('film'), ior, thickness: mix(thinnest, thickest, reader.number('filmThickness')) };
}

function fuzzAt(reader: LayerReader, { colorTexture }: NonNullable<Material['sheen']>): FuzzNodes {
  const color = reader.vector(4).xyz.toVar();
  if (colorTexture) color.mulAssign(reader.sample(colorTexture).rgb);
  return { color, roughness: reader.number('sheenRoughness') };
}

function groovesAt(
  reader: LayerReader,
  sources: SurfaceSources,
  { directionTexture: texture }: NonNullable<Material['anisotropy']>,
): GroovesHere {
  const { x: strength, y: c, z: s } = reader.vector(5).toVar();
  const uv = uvDirectionsHere(sources);
  if (!texture) return { uv, direction: vec2(c, s), strength };
  const texel = reader.sample(texture).toVar();
  const { x, y } = texel.xy.mul(2).sub(1).toVar();
  const direction = vec2(c.mul(x).sub(s.mul(y)), s.mul(x).add(c.mul(y))).toVar();
  return { uv, direction, strength: strength.mul(texel.z).toVar() };
}

/** Before any discard, because normal maps need derivatives between neighbouring fragments. */
function readLayers(reader: LayerReader, sources: SurfaceSources, like: Material): SurfaceLayers {
  const { specular, anisotropy, clearcoat, sheen, iridescence } = like;
  const color = specular && reader.vector(0).xyz.toVar();
  if (color && specular.colorTexture) color.mulAssign(reader.sample(specular.colorTexture).rgb);
  const map = clearcoat?.normalTexture;
  const coatNormal =
    clearcoat && frontNormal(sources, map && { texture: reader.texture(map.texture), strength: reader.vector(1).xy });
  return {
    ...(color && { specular: { factor: reader.number('specular'), color } }),
    ...(anisotropy && { grooves: groovesAt(reader, sources, anisotropy) }),
    ...(sheen && { fuzz: fuzzAt(reader, sheen) }),
    ...(iridescence && { film: filmOf(reader) }),
    ...(coatNormal && {
      coat: {
        factor: reader.number('clearcoat'),
        roughness: reader.number('clearcoatRoughness'),
        normal: coatNormal,
      },
    }),
  };
}
