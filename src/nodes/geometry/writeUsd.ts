import { extensionOf, type FileSource, resolvePath } from '../../formats/files/fileSource.ts';
import type { StageArc } from '../../formats/usd/write/existingStage.ts';
import { msg } from '../../messages/message.ts';
import { SPEED_OF_LIGHT } from '../../physics/constants.ts';
import { placeUnder } from '../../scene/compose/placeUnder.ts';
import { InputError, type Scene } from '../../scene/types.ts';
import { nodeRefusal } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { checkedFileName, type SceneOutput } from '../project/outputFiles.ts';
import type { Services } from '../services.ts';

/** Requests that geometry is written as USD; passes it through. */
export const writeUsdNode = defineNode({
  id: 'write-usd',
  title: msg`Write USD`,
  help: msg`Requests that the geometry is written as USD, and passes it through. The node’s button downloads it; “slowlight render PROJECT” without -o writes it.`,
  category: 'geometry',
  params: {
    name: {
      kind: 'text',
      title: msg`File name`,
      help: msg`Without folders. \`.usda\` is text, \`.usdz\` a package with textures, \`.usdc\` binary and smaller.`,
      default: 'geometry.usda',
    },
    prim: {
      kind: 'text',
      title: msg`Prim path`,
      help: msg`Everything is written below this prim, such as /geom/geometry; empty: where it is.`,
      default: '',
    },
    into: {
      kind: 'text',
      title: msg`Into the stage`,
      help: msg`A USD file of the project. A new stage is written that has it and the geometry; the file itself is not changed. Keep them in one folder.`,
      default: '',
      file: true,
    },
    arc: {
      kind: 'choice',
      title: msg`As`,
      help: msg`Sublayer: a layer below those of the stage. Payload: of a new prim, which programs can leave unloaded.`,
      default: 'sublayer',
      options: [
        { value: 'sublayer', title: msg`Sublayer` },
        { value: 'payload', title: msg`Payload` },
      ],
      onlyWhen: { param: 'into', isNot: '' },
    },
    motion: {
      kind: 'choice',
      title: msg`Motion`,
      help: msg`Sampled motions can be read by every program; the time range is that of the input, else of the geometry. Exact motions and rest shapes are read by Slowlight only.`,
      default: 'sampled',
      options: [
        { value: 'sampled', title: msg`Sampled` },
        { value: 'exact', title: msg`Exact` },
      ],
    },
    speedOfLight: {
      kind: 'number',
      title: msg`Speed of light`,
      help: msg`Moving rest shapes are contracted by it; it is written to the file as the suggested speed of light.`,
      unit: 'm/s',
      default: SPEED_OF_LIGHT,
      min: 0.1,
      max: SPEED_OF_LIGHT,
      step: 0.1,
      scale: 'log',
      suggestion: 'speedOfLight',
    },
  },
  inputs: { geometry: { type: 'geometry' }, time: { type: 'time', optional: true } },
  outputs: { geometry: { type: 'geometry' }, file: { type: 'file', title: msg`File` } },
  async evaluate({ geometry, time }, { name, prim, into, arc, motion, speedOfLight }, { node, services }) {
    const during = time ? { startTime: time.start, endTime: time.end } : {};
    const { hints } = geometry.scene;
    const scene = { ...geometry.scene, ...during, hints: { ...hints, ...(speedOfLight && { speedOfLight }) } };
    const sampled = motion === 'sampled';
    const path = checkedPrimPath(prim, into !== '', node);
    if (into === '') {
      const written = checkedFileName(name, ['usda', 'usdz', 'usdc'], node);
      const placed = path === '' ? scene : placeUnder(scene, path);
      return { geometry, file: { kind: 'scene', name: written, scene: placed, sampled } };
    }
    const file = { name: checkedFileName(name, ['usda'], node), path, into, arc };
    return { geometry, file: { ...(await inStage(scene, file, node, services)), sampled } };
  },
});

/** USD allows letters, digits and _; the depth is bounded. */
function checkedPrimPath(path: string, isNeeded: boolean, node: string): string {
  if (path === '' && !isNeeded) return '';
  if (/^(?:\/[\p{L}_][\p{L}\p{N}_]{0,63}){1,32}$/u.test(path)) return path;
  const value = '/geom/geometry';
  const message = msg`"${path.slice(0, 80)}" is no path of a prim; write one like ${value}`;
  throw nodeRefusal('usd.prim-path', `${node}.prim`, message, { node, param: 'prim', value });
}

interface StageFile {
  readonly name: string;
  readonly path: string;
  readonly into: string;
  readonly arc: StageArc;
}

/** The geometry in units and axes of a stage, and a new root layer that has both. Throws a NodeRefusal if the stage cannot be read, has a prim there, or other axes. */
async function inStage(
  scene: Scene,
  { name, path, into, arc }: StageFile,
  node: string,
  services: Services,
): Promise<Omit<SceneOutput, 'sampled'>> {
  if (/[@\n]/.test(into))
    throw nodeRefusal(
      'usd.stage',
      node,
      msg`the name ${into} has characters that USD takes for the end of it; rename the file`,
    );
  const stageFile = besideResult(into);
  try {
    const { existingStage, placedStageText } = await import('../../formats/usd/write/existingStage.ts');
    const stage = await existingStage(filesBeside(into, services), stageFile, path);
    if (stage.upAxis !== scene.upAxis)
      throw nodeRefusal(
        'usd.up-axis',
        node,
        msg`in ${stageFile} ${stage.upAxis} is up, in the geometry ${scene.upAxis}; make the geometry in the axes of the stage`,
      );
    const { metersPerUnit, timeCodesPerSecond } = stage;
    // A payload has its own root, which becomes the prim.
    const place = arc === 'payload' ? path.slice(path.lastIndexOf('/')) : path;
    const placed = { ...placeUnder(scene, place), metersPerUnit, timeCodesPerSecond };
    const geometryFile = `${name.slice(0, -extensionOf(name).length - 1)}.geometry.usdc`;
    if ([name, geometryFile].includes(stageFile.slice(stageFile.lastIndexOf('/') + 1)))
      throw nodeRefusal(
        'usd.stage',
        `${node}.name`,
        msg`this would overwrite ${stageFile}, the stage that the geometry goes into; choose another file name`,
      );
    const [start, end] = [scene.startTime * timeCodesPerSecond, scene.endTime * timeCodesPerSecond];
    const text = placedStageText(stage, {
      stageFile: `./${stageFile}`,
      geometryFile: `./${geometryFile}`,
      path,
      arc,
      start,
      end,
      ...(scene.hints.speedOfLight && { speedOfLight: scene.hints.speedOfLight }),
    });
    return { kind: 'scene', name, scene: placed, stage: { text, geometryFile } };
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    const { code, place, message } = error.diagnostic;
    throw nodeRefusal(code, place, message);
  }
}

/** Where the stage will be from the new one: at its path in the project, or, as a file of the page (`local:1/set/stage.usda`) or an address, beside it. */
const besideResult = (into: string): string => (/^[a-z]+:/i.test(into) ? (into.split(/[/@]/).at(-1) ?? into) : into);

/** The files around the stage, as far as they are there, by their paths from where it will be. */
const filesBeside = (into: string, { readFile }: Services): FileSource => ({
  read: async (path) => {
    try {
      return await readFile(into === besideResult(into) ? path : resolvePath(into, path));
    } catch (error) {
      if (error instanceof InputError && error.diagnostic.code === 'file.missing') return undefined;
      throw error;
    }
  },
});
