import { msg } from '../../messages/message.ts';
import { assignTexture, canProject, hasUvs } from '../../scene/compose/assignTexture.ts';
import { matchesPath } from '../../scene/compose/mergeScenes.ts';
import { checkerTexture } from '../../scene/materials/checker.ts';
import type { Scene, Texture } from '../../scene/types.ts';
import { assertPathExists, nodeRefusal, readOrRefuse, whichParam } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import type { Services } from '../services.ts';
import { lengthParam } from './primitives/definePrimitive.ts';

const CHECKER = { param: 'picture', is: 'checker' } as const;
const IMAGE = { param: 'picture', is: 'image' } as const;
const OWN = { param: 'mapping', is: 'own' } as const;

/** Puts a checkerboard or a picture on surfaces. */
export const textureNode = defineNode({
  id: 'texture',
  title: msg`Texture`,
  help: msg`A checkerboard or a picture on surfaces, in place of their colour. The rest of their material stays: put it after Material.`,
  category: 'geometry',
  params: {
    which: whichParam,
    picture: {
      kind: 'choice',
      title: msg`Pattern`,
      default: 'checker',
      options: [
        { value: 'checker', title: msg`Checkerboard` },
        { value: 'image', title: msg`Image` },
      ],
    },
    file: { kind: 'text', title: msg`File`, help: msg`A PNG or JPEG.`, default: '', file: true, onlyWhen: IMAGE },
    first: { kind: 'color', title: msg`First colour`, default: [0.8, 0.8, 0.8], onlyWhen: CHECKER },
    second: { kind: 'color', title: msg`Second colour`, default: [0.1, 0.1, 0.1], onlyWhen: CHECKER },
    tint: { kind: 'color', title: msg`Tint`, default: [1, 1, 1], onlyWhen: IMAGE },
    filter: {
      kind: 'choice',
      title: msg`Filter`,
      help: msg`Nearest: texels have sharp edges. Linear: they blend.`,
      default: 'nearest',
      options: [
        { value: 'nearest', title: msg`Nearest` },
        { value: 'linear', title: msg`Linear` },
      ],
    },
    mapping: {
      kind: 'choice',
      title: msg`Mapping`,
      help: msg`By the surface’s own texture coordinates, or projected along the axes.`,
      default: 'own',
      options: [
        { value: 'own', title: msg`Its own` },
        { value: 'projected', title: msg`Projected` },
      ],
    },
    countU: { ...countOf(msg`Cells or pictures along u`), onlyWhen: OWN },
    countV: { ...countOf(msg`Cells or pictures along v`), onlyWhen: OWN },
    size: { ...lengthParam(msg`Size of a cell or picture`, 1), onlyWhen: { param: 'mapping', is: 'projected' } },
  },
  inputs: { geometry: { type: 'geometry' } },
  outputs: { geometry: { type: 'geometry' } },
  async evaluate(
    { geometry },
    { which, picture, file, first, second, tint, filter, mapping, countU, countV, size },
    { node, services },
  ) {
    const { scene } = geometry;
    assertPathExists(scene, which, node);
    const isProjected = mapping === 'projected';
    assertMappable(scene, which, isProjected, node);
    const isImage = picture === 'image';
    const texture = isImage ? await readImage(file, filter, node, services) : checkerTexture([first, second], filter);
    // A checkerboard texture has two cells along each side.
    const cells = isImage ? 1 : 2;
    const made = assignTexture(scene, which, {
      texture,
      tint: isImage ? tint : [1, 1, 1],
      repeat: [countU / cells, countV / cells],
      ...(isProjected && { projected: cells * size }),
    });
    return { geometry: { ...geometry, scene: made } };
  },
});

function countOf(title: ReturnType<typeof msg>) {
  return { kind: 'number', title, default: 8, min: 0.001, max: 10_000, step: 1, scale: 'log' } as const;
}

function assertMappable({ objects }: Scene, which: string, isProjected: boolean, node: string): void {
  const chosen = objects.filter(({ path }) => matchesPath(path, which));
  const bare = isProjected ? chosen.find((object) => !canProject(object)) : chosen.find(({ mesh }) => !hasUvs(mesh));
  if (!bare) return;
  const other = (value: string) => ({ node, param: 'mapping', value });
  throw isProjected
    ? nodeRefusal(
        'texture.deforming',
        bare.path,
        msg`${bare.path} deforms, so that a projected texture would slide over it; use its own coordinates`,
        other('own'),
      )
    : nodeRefusal(
        'texture.uv',
        bare.path,
        msg`${bare.path} has no texture coordinates; project the texture instead`,
        other('projected'),
      );
}

async function readImage(file: string, filter: Texture['filter'], node: string, services: Services): Promise<Texture> {
  if (file === '') throw nodeRefusal('texture.none', node, msg`no image is named; name a PNG or JPEG`);
  const { decodeImage } = await import('../../formats/image/decodeImage.ts');
  const image = await readOrRefuse(async () => decodeImage(await services.readFile(file), file));
  return { name: file, ...image, colorSpace: 'srgb', filter, wrapS: 'repeat', wrapT: 'repeat' };
}
