import type { Scene } from '../../../scene/types.ts';
import { lightContent, pictureOf, spectrumOf } from './lights/lights.ts';
import { hintLines, MaterialWriter, TextureFiles } from './materials.ts';
import type { WriteContext } from './motionLines.ts';
import { packUsdz } from './packUsdz.ts';
import { cameraContent, meshContent } from './prims.ts';
import { PrimTree } from './primTree.ts';
import { double, type Lines } from './usdaText.ts';

/**
 * A scene as USD text. Samples are written as they are: usd-core reads back the same f32 points, and poses as doubles.
 * Textures are named `textures/NAME.png`; `writeTextures` gives those files.
 */
export function writeUsda(scene: Scene): string {
  const tree = new PrimTree();
  const files = new TextureFiles(scene);
  const materials = new MaterialWriter(scene, tree, files);
  // All paths are claimed before any is used, so that a clash changes the same names wherever they stand.
  const claimed = <T extends { readonly path: string }>(items: readonly T[]) =>
    items.map((item) => ({ item, path: tree.claim(item.path) }));
  const [objects, cameras, lights] = [claimed(scene.objects), claimed(scene.cameras), claimed(scene.lights)];
  const placed = new Set([...objects, ...cameras, ...lights].map(({ path }) => path));
  const placement = (path: string): WriteContext => ({
    metersPerUnit: scene.metersPerUnit,
    codesPerSecond: scene.timeCodesPerSecond,
    nested: ancestors(path).some((ancestor) => placed.has(ancestor)),
  });
  for (const { item, path } of objects) {
    const colored = item.mesh.colors !== undefined;
    tree.set(
      path,
      meshContent(item, placement(path), (index) => materials.path(index, colored)),
    );
  }
  for (const { item, path } of cameras) tree.set(path, cameraContent(item, placement(path)));
  for (const { item, path } of lights) {
    const [picture, spectrum] = [pictureOf(item), spectrumOf(item)];
    const named = {
      picture: picture && files.path(picture),
      spectrum: spectrum && files.spectrum(spectrum),
    };
    tree.set(path, lightContent(item, placement(path), named));
  }
  return `${[...headerLines(scene, tree), ...tree.lines()].join('\n')}\n`;
}

/** `/A/B/C` → `/A/B`, `/A` */
function ancestors(path: string): string[] {
  const end = path.lastIndexOf('/');
  return end > 0 ? [path.slice(0, end), ...ancestors(path.slice(0, end))] : [];
}

/** The textures and spectra that `writeUsda` names, as files by their paths. */
export const writeTextures = (scene: Scene): Map<string, Uint8Array> => new TextureFiles(scene).encoded();

/** A scene and its textures as one package. The same scene gives the same bytes. */
export function writeUsdz(scene: Scene): Uint8Array {
  const layer = new TextEncoder().encode(writeUsda(scene));
  return packUsdz(new Map([['scene.usda', layer], ...writeTextures(scene)]));
}

function headerLines(scene: Scene, tree: PrimTree): Lines {
  const [first] = tree.rootNames();
  const code = (t: number): string => double(t * scene.timeCodesPerSecond);
  const metadata = [
    ...hintLines(scene),
    ...(first ? [`defaultPrim = "${first}"`] : []),
    `endTimeCode = ${code(scene.endTime)}`,
    `metersPerUnit = ${double(scene.metersPerUnit)}`,
    `startTimeCode = ${code(scene.startTime)}`,
    `timeCodesPerSecond = ${double(scene.timeCodesPerSecond)}`,
    `upAxis = "${scene.upAxis}"`,
  ];
  return ['#usda 1.0', '(', ...metadata.map((line) => `    ${line}`), ')'];
}
