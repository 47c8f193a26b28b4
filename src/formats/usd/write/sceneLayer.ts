import { isEternal } from '../../../scene/motion/lifetimes.ts';
import type { Lifetime, Light, LocalLight, Scene, SceneObject } from '../../../scene/types.ts';
import { ancestors } from '../../write/paths.ts';
import type { Dictionary, Layer, MetadataValue, Value } from '../layer/layer.ts';
import { double, string, token, tuple } from '../layer/values.ts';
import { isOneMesh, meshOfPieces } from './changingMesh.ts';
import { lightContent, pictureOf, spectrumOf } from './lights/lights.ts';
import { MaterialWriter, TextureFiles } from './materials.ts';
import type { WriteContext } from './motions.ts';
import { cameraContent } from './prims.ts';
import { PrimTree } from './primTree.ts';
import { carriedForm } from './skeletons/carriedMesh.ts';
import { SkeletonPrims } from './skeletons/skeletonPrims.ts';
import { usdObjects } from './skeletons/usdObjects.ts';
import { thingsOf, type WrittenThing } from './things.ts';

/**
 * A scene as a layer. Samples are written as they are: points stay the same f32, poses doubles. Textures are named
 * `textures/NAME.png`, and made by the `TextureFiles`.
 */
export function sceneLayer(scene: Scene, name: string): Layer {
  const tree = new PrimTree();
  const files = new TextureFiles(scene);
  const materials = new MaterialWriter(scene, tree, files);
  const { objects: sceneObjects, skeletons } = usdObjects(scene);
  const own = [...sceneObjects, ...scene.cameras, ...scene.lights].map(pathOfWhole);
  const around = new Set(own.flatMap(ancestors));
  // All paths are claimed before any is used, so that a clash changes the same names wherever they stand.
  const claimed = <T extends { readonly path: string }>(items: readonly T[]) =>
    items.map((item) => ({ item, path: tree.claim(item.path) }));
  const objects = claimed(thingsOf(sceneObjects, (pieces, path) => !around.has(path) && isOneMesh(pieces)));
  const cameras = claimed(scene.cameras);
  const lights = claimed(lightThings(scene.lights, around));
  const placed = new Set([...objects, ...cameras, ...lights].map(({ path }) => path));
  const pathsOfObjects = new Map(
    objects.flatMap(({ item, path }) => item.pieces.map((piece) => [piece, path] as const)),
  );
  const skeletonPrims = new SkeletonPrims(tree, skeletons, pathsOfObjects, placed);
  const parents = new Set([...placed].flatMap(ancestors));
  const mortalParents = new Set(
    objects.flatMap(({ item, path }) => (parents.has(path) && !isEternal(item.pieces[0].lifetime) ? [path] : [])),
  );
  const placement = (path: string, pieces: readonly { readonly lifetime: Lifetime }[]): WriteContext => ({
    metersPerUnit: scene.metersPerUnit,
    codesPerSecond: scene.timeCodesPerSecond,
    startTime: scene.startTime,
    nested: ancestors(path).some((ancestor) => placed.has(ancestor)),
    isParent: parents.has(path),
    inheritsLife: ancestors(path).some((ancestor) => mortalParents.has(ancestor)),
    lives: pieces.map(({ lifetime }) => lifetime),
  });
  skeletonPrims.write((path) => placement(path, []));
  for (const { item, path: claimedPath } of objects) {
    const path = skeletonPrims.pathOf(item.pieces[0]) ?? claimedPath;
    const colored = item.pieces.some(({ mesh }) => mesh.colors !== undefined);
    const surroundings = {
      materialOf: (index: number) => materials.path(index, colored),
      innerName: (wanted: string) => tree.innerName(path, wanted),
      formOf: (object: SceneObject, context: WriteContext) =>
        skeletonPrims.formOf(object, context) ?? carriedForm(object, context),
    };
    tree.set(path, meshOfPieces(item.pieces, placement(path, item.pieces), surroundings));
  }
  for (const { item, path } of cameras) tree.set(path, cameraContent(item, placement(path, [])));
  for (const { item, path } of lights) {
    const [light] = item.pieces;
    const [picture, spectrum] = [pictureOf(light), spectrumOf(light)];
    const named = {
      picture: picture && files.path(picture),
      spectrum: spectrum && files.spectrum(spectrum),
    };
    tree.set(path, lightContent(light, placement(path, item.pieces.filter(isLocal)), named));
  }
  const rootPrims = tree.rootPrims();
  return { name, metadata: metadataOf(scene, [...rootPrims.keys()]), rootPrims };
}

const isLocal = (light: Light): light is LocalLight => 'lifetime' in light;

/** Local lights with all their lives, and the others. */
function lightThings(lights: readonly Light[], around: ReadonlySet<string>): WrittenThing<Light>[] {
  const things = new Map<Light, WrittenThing<Light>>();
  for (const thing of thingsOf(lights.filter(isLocal), (_, path) => !around.has(path)))
    things.set(thing.pieces[0], thing);
  // In the scene's order.
  return lights.flatMap((light) =>
    isLocal(light) ? (things.get(light) ?? []) : { path: light.path, pieces: [light] },
  );
}

const pathOfWhole = (item: { readonly path: string; readonly pieceOf?: string }): string => item.pieceOf ?? item.path;

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
