import type { Scene } from '../../../scene/types.ts';
import type { Dictionary, Layer, MetadataValue, Value } from '../layer/layer.ts';
import { lightContent, pictureOf, spectrumOf } from './lights/lights.ts';
import { MaterialWriter, TextureFiles } from './materials.ts';
import type { WriteContext } from './motions.ts';
import { cameraContent, meshContent } from './prims.ts';
import { PrimTree } from './primTree.ts';
import { double, string, token, tuple } from './values.ts';

/**
 * A scene as a layer. Samples are written as they are: points stay the same f32, poses doubles. Textures are named
 * `textures/NAME.png`, and made by the `TextureFiles`.
 */
export function sceneLayer(scene: Scene, name: string): Layer {
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
    const surroundings = {
      materialOf: (index: number) => materials.path(index, colored),
      innerName: (wanted: string) => tree.innerName(path, wanted),
    };
    tree.set(path, meshContent(item, placement(path), surroundings));
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
  const rootPrims = tree.rootPrims();
  return { name, metadata: metadataOf(scene, [...rootPrims.keys()]), rootPrims };
}

/** `/A/B/C` → `/A/B`, `/A` */
function ancestors(path: string): string[] {
  const end = path.lastIndexOf('/');
  return end > 0 ? [path.slice(0, end), ...ancestors(path.slice(0, end))] : [];
}

function metadataOf(scene: Scene, [first]: readonly string[]): Map<string, MetadataValue> {
  const code = (t: number): Value => double(t * scene.timeCodesPerSecond);
  const hints = hintsOf(scene);
  return new Map<string, MetadataValue>([
    ...(hints.size > 0
      ? [['customLayerData', dictionary({ slowlight: { type: 'dictionary', data: hints } })] as const]
      : []),
    ...(first === undefined ? [] : [['defaultPrim', token(first)] as const]),
    ['endTimeCode', code(scene.endTime)],
    ['metersPerUnit', double(scene.metersPerUnit)],
    ['startTimeCode', code(scene.startTime)],
    ['timeCodesPerSecond', double(scene.timeCodesPerSecond)],
    ['upAxis', token(scene.upAxis)],
  ]);
}

const dictionary = (entries: Readonly<Record<string, Value>>): Value => ({
  type: 'dictionary',
  data: new Map(Object.entries(entries)),
});

/** What the author suggests, as the layer's `customLayerData`. */
function hintsOf({ hints }: Scene): Dictionary {
  const { speedOfLight, title, lookFor, beta, openAt } = hints;
  return new Map([
    ...(beta ? [['beta', tuple('double3', beta)] as const] : []),
    ...(lookFor !== undefined ? [['lookFor', string(lookFor)] as const] : []),
    ...(openAt !== undefined ? [['openAt', double(openAt)] as const] : []),
    ...(speedOfLight !== undefined ? [['speedOfLight', double(speedOfLight)] as const] : []),
    ...(title !== undefined ? [['title', string(title)] as const] : []),
  ]);
}
