import { rotate } from '../../math/quat.ts';
import { add, type Vec3 } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { bakedMesh } from '../../scene/mesh/stretch.ts';
import { sampleTimes } from '../../scene/motion/motion.ts';
import type { Material, Mesh, Pose, Scene, Texture, TextureChannel } from '../../scene/types.ts';
import { DiagnosticLog } from '../diagnostics/diagnosticLog.ts';
import { redTexture } from '../image/channelTexture.ts';
import { encodeTexture } from '../image/encodeTexture.ts';
import { type ExportedScene, exportObjects, exportPoses, vectorYUp } from '../write/exportMotion.ts';

/**
 * Writes a scene as Wavefront OBJ with its MTL and textures, in metres with Y up. OBJ holds only geometry: moving objects
 * are written at their first sample; losses are reported as diagnostics.
 */
export function writeObj(scene: Scene, name: string): ExportedScene {
  const losses = new DiagnosticLog(name);
  const base = name.replace(/\.[^.]*$/, '');
  const library = new MtlWriter(scene.materials, base);
  // Indices count from 1, across all objects.
  let first = 1;
  const parts = [['# Y up, metres', `mtllib ${base}.mtl`]];
  for (const object of exportObjects(scene, losses)) {
    const { path, motion } = object;
    const mesh = bakedMesh(object);
    const times = sampleTimes(motion);
    if (times)
      losses.add('warning', 'convert.motion', path, msg`OBJ has no motion: it is written where it is at ${times[0]} s`);
    const name = path.replace(/^\//, '').replace(/\s/g, '_');
    parts.push([`o ${name}`], vertexLines(scene, mesh, exportPoses(motion)[0]), faceLines(mesh, first, library));
    first += mesh.positions.length / 3;
  }
  if (Object.keys(scene.hints).length > 0)
    losses.add('info', 'convert.hints', '', msg`OBJ has no place for what the author suggests for viewing`);
  for (const { path } of [...scene.lights, ...scene.cameras])
    losses.add('warning', 'convert.left-out', path, msg`OBJ has no lights and no cameras; it is left out`);
  const encode = (text: readonly string[]): Uint8Array => new TextEncoder().encode(`${text.join('\n')}\n`);
  const files = new Map([
    [name, encode(parts.flat())],
    [`${base}.mtl`, encode(library.lines())],
    ...library.pictures(),
  ]);
  return { files, diagnostics: losses.list() };
}

function vertexLines(scene: Scene, { positions, normals, uvs, colors }: Mesh, pose: Pose): string[] {
  const at = (values: Float32Array, i: number): Vec3 => [values[i], values[i + 1], values[i + 2]];
  const [v, vt, vn]: string[][] = [[], [], []];
  for (let i = 0; i < positions.length; i += 3) {
    const p = vectorYUp(scene, add(pose.position, rotate(pose.orientation, at(positions, i))));
    v.push(`v ${numbers(p)}${colors ? ` ${numbers(at(colors, i))}` : ''}`);
    vn.push(`vn ${numbers(vectorYUp(scene, rotate(pose.orientation, at(normals, i))))}`);
    vt.push(`vt ${numbers([uvs[(2 * i) / 3], uvs[(2 * i) / 3 + 1]])}`);
  }
  return [...v, ...vt, ...vn];
}

function faceLines({ indices, groups }: Mesh, first: number, library: MtlWriter): string[] {
  return groups.flatMap(({ start, count, material }) => {
    const lines = [`usemtl ${library.name(material)}`];
    for (let i = start; i < start + count; i += 3) {
      const corners = [0, 1, 2].map((k) => indices[i + k] + first);
      lines.push(`f ${corners.map((n) => `${n}/${n}/${n}`).join(' ')}`);
    }
    return lines;
  });
}

/** Nine significant digits represent every f32 exactly. */
const numbers = (values: readonly number[]): string => values.map((x) => Number(x.toPrecision(9))).join(' ');

/** Writes materials with unique names, and collects their textures. */
class MtlWriter {
  private readonly materials: readonly Material[];
  private readonly base: string;
  private readonly names: readonly string[];
  private readonly files = new Map<Uint8Array, readonly [string, Texture]>();
  private readonly reds = new Map<TextureChannel, Texture>();

  constructor(materials: readonly Material[], base: string) {
    this.materials = materials;
    this.base = base;
    const used = new Set<string>();
    this.names = materials.map(({ name }) => {
      const requested = name.replace(/^\//, '').replace(/\s/g, '_') || 'material';
      let unique = requested;
      for (let n = 1; used.has(unique); n++) unique = `${requested}_${n}`;
      used.add(unique);
      return unique;
    });
  }

  name(index: number): string {
    return this.names[index];
  }

  lines(): string[] {
    return this.materials.flatMap((m, i) => [
      `newmtl ${this.names[i]}`,
      `Kd ${numbers(m.baseColor)}`,
      `Ke ${numbers(m.emissive)}`,
      `d ${numbers([m.opacity])}`,
      `Pr ${numbers([m.roughnessTexture ? 1 : m.roughness])}`,
      `Pm ${numbers([m.metallicTexture ? 1 : m.metallic])}`,
      ...(m.ior === undefined ? [] : [`Ni ${numbers([m.ior])}`]),
      ...(m.baseColorTexture ? [`map_Kd ${this.file(m.baseColorTexture)}`] : []),
      ...(m.emissiveTexture ? [`map_Ke ${this.file(m.emissiveTexture)}`] : []),
      ...(m.normalTexture ? [`norm ${this.file(m.normalTexture.texture)}`] : []),
      ...this.channel('map_Pr', m.roughnessTexture),
      ...this.channel('map_Pm', m.metallicTexture),
    ]);
  }

  /** OBJ reads scalar maps from their red channel; other channels are copied to one. */
  private channel(keyword: string, from: TextureChannel | undefined): string[] {
    if (!from) return [];
    const values = this.reds.get(from) ?? redTexture(from);
    this.reds.set(from, values);
    return [`${keyword} ${this.file(values)}`];
  }

  /** The PNG files by name; call after `lines`. */
  pictures(): [string, Uint8Array][] {
    return [...this.files.values()].map(([name, t]) => [name, encodeTexture(t.width, t.height, t.data)]);
  }

  private file(texture: Texture): string {
    const existing = this.files.get(texture.data);
    const name = existing?.[0] ?? `${this.base}_${this.files.size}.png`;
    this.files.set(texture.data, [name, texture]);
    return name;
  }
}
