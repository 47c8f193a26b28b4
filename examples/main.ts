import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { encodeTexture } from '../src/formats/image/encodeTexture.ts';
import { sceneLayer, writeCrate, writeTextures, writeUsda } from '../src/formats/usd/index.ts';
import type { GraphDocument } from '../src/graph/document/document.ts';
import { serializeDocument } from '../src/graph/document/serialize.ts';
import { inEnglish, msg } from '../src/messages/message.ts';
import { SPEED_OF_LIGHT } from '../src/physics/constants.ts';
import type { Scene, Texture } from '../src/scene/types.ts';
import { validate } from '../src/scene/validation/validate.ts';
import type { ExampleScene } from './kit/example.ts';
import { packLayer } from './kit/pack.ts';
import { panoramas } from './panoramas/index.ts';
import { projects } from './projects/index.ts';
import { scenes } from './scenes/index.ts';
import { sets } from './sets/index.ts';

/** This file runs from dist/examples/examples. */
const folder = fileURLToPath(new URL('../../../examples/', import.meta.url));

for (const name of chosen(process.argv.slice(2))) {
  const project = projects[name];
  const panorama = panoramas[name];
  if (project) writeProject(name, project());
  else if (panorama) writePanorama(panorama());
  else if (sets.some((set) => set.name === name)) write(find(sets, name), 'sets/');
  else write(find(scenes, name));
}

function chosen(names: readonly string[]): readonly string[] {
  return names.length > 0
    ? names
    : [...[...scenes, ...sets].map(({ name }) => name), ...Object.keys(panoramas), ...Object.keys(projects)];
}

function find(among: readonly ExampleScene[], name: string): ExampleScene {
  return among.find((scene) => scene.name === name) ?? unknown(name);
}

function unknown(name: string): never {
  throw new Error(`no scene ${name}; there are ${chosen([]).join(', ')}`);
}

/** `under`: a subfolder of examples/ with its own textures. */
function write({ name, make, texturesOf = name, readable = false }: ExampleScene, under = ''): void {
  const scene = named(make(), texturesOf);
  const faults = validate(scene, scene.hints.speedOfLight ?? SPEED_OF_LIGHT).filter((d) => d.severity === 'error');
  if (faults.length > 0)
    throw new Error(faults.map((d) => inEnglish(msg`${name}: ${d.place}: ${d.message}`)).join('\n'));
  const file = `${name}.${readable ? 'usda' : 'usdc'}`;
  const bytes = readable ? new TextEncoder().encode(writeUsda(scene)) : writeCrate(packLayer(sceneLayer(scene, file)));
  const place = join(folder, under);
  mkdirSync(place, { recursive: true });
  writeFileSync(join(place, file), bytes);
  for (const [path, content] of writeTextures(scene)) {
    mkdirSync(dirname(join(place, path)), { recursive: true });
    writeFileSync(join(place, path), content);
  }
  const triangles = scene.objects.reduce((sum, { mesh }) => sum + mesh.indices.length / 3, 0);
  console.log(
    `${under}${file}  ${(bytes.length / 1024).toFixed(0)} KiB, ${triangles} triangles, ${scene.objects.length} objects`,
  );
}

function writeProject(name: string, document: GraphDocument): void {
  writeFileSync(join(folder, `${name}.slowlight.json`), serializeDocument(document));
  console.log(`${name}.slowlight.json  ${Object.keys(document.nodes).length} nodes`);
}

function writePanorama({ name, width, height, data }: Texture): void {
  const bytes = encodeTexture(width, height, data);
  writeFileSync(join(folder, 'panoramas', name), bytes);
  console.log(`panoramas/${name}  ${(bytes.length / 1024).toFixed(0)} KiB`);
}

/** The scenes share a folder of textures, so the names of textures begin with that of the scene. */
function named(scene: Scene, prefix: string): Scene {
  const rename = (texture: Texture): Texture => ({ ...texture, name: `${prefix}_${texture.name}` });
  const materials = scene.materials.map((material) =>
    material.baseColorTexture ? { ...material, baseColorTexture: rename(material.baseColorTexture) } : material,
  );
  return { ...scene, materials };
}
