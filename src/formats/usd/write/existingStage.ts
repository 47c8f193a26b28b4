import { msg } from '../../../messages/message.ts';
import { DiagnosticList } from '../../diagnostics/diagnosticLog.ts';
import { inputError } from '../../diagnostics/inputError.ts';
import type { FileSource } from '../../files/fileSource.ts';
import { AssetFiles } from '../assets/assetFiles.ts';
import { composeStage } from '../compose/composeStage.ts';
import { LayerStore } from '../compose/layers/layerStore.ts';
import { metadataNumber, metadataText, primAt, primsAlong, stageTimeCode } from '../layer/query.ts';
import { layerParser } from '../readLayer.ts';
import { hintsOf } from '../schema/slowlightAttributes.ts';

/** What has to be known of a stage to put something into it. */
export interface ExistingStage {
  readonly upAxis: 'Y' | 'Z';
  readonly metersPerUnit: number;
  readonly timeCodesPerSecond: number;
  /** As written [time codes]. */
  readonly startTimeCode?: number;
  readonly endTimeCode?: number;
  readonly defaultPrim?: string;
  /** That it suggests [m/s]. */
  readonly speedOfLight?: number;
  /** How many prims along the path are there. */
  readonly ancestors: number;
}

/** Composes a stage and looks at the place of a prim; throws an InputError if a prim is there already, or the stage cannot be read. */
export async function existingStage(source: FileSource, entry: string, path: string): Promise<ExistingStage> {
  const files = new AssetFiles(source, entry);
  const content = await files.content(entry);
  if (!content) throw inputError('file.missing', entry, msg`no such file`);
  const diagnostics = new DiagnosticList();
  const store = new LayerStore(files, layerParser(files, diagnostics));
  const { layer } = await composeStage(store, await store.root(entry, content), diagnostics, {});
  if (primAt(layer, path))
    throw inputError(
      'usd.prim-exists',
      entry,
      msg`there is a prim ${path} already, and nothing is overwritten; choose another path`,
    );
  const number = (key: string): number | undefined => metadataNumber(layer.metadata, key);
  const [start, end] = [stageTimeCode(layer.metadata, 'start'), stageTimeCode(layer.metadata, 'end')];
  const first = metadataText(layer.metadata, 'defaultPrim');
  const { speedOfLight: suggested } = hintsOf(layer);
  return {
    upAxis: metadataText(layer.metadata, 'upAxis') === 'Z' ? 'Z' : 'Y',
    metersPerUnit: number('metersPerUnit') ?? 0.01,
    timeCodesPerSecond: number('timeCodesPerSecond') ?? number('framesPerSecond') ?? 24,
    ...(start !== undefined && { startTimeCode: start }),
    ...(end !== undefined && { endTimeCode: end }),
    ...(first !== undefined && { defaultPrim: first }),
    ...(suggested !== undefined && { speedOfLight: suggested }),
    ancestors: primsAlong(layer, path).length,
  };
}

/** How geometry comes into a stage: as a layer below it, or as a payload of a new prim. */
export type StageArc = 'sublayer' | 'payload';

interface StagePlacement {
  /** Of the stage, and of the layer with the geometry, relative to the new file. */
  readonly stageFile: string;
  readonly geometryFile: string;
  readonly path: string;
  readonly arc: StageArc;
  /** Time range of the geometry [time codes]. */
  readonly start: number;
  readonly end: number;
  /** That of the geometry, where the stage suggests none [m/s]. */
  readonly speedOfLight?: number;
}

/**
 * A new root layer of the stage with the geometry in it; the stage's own files stay as they are. A sublayer is the
 * weakest, so that it changes no opinion of the stage; a payload is of a prim that only this layer has.
 */
export function placedStageText(stage: ExistingStage, placement: StagePlacement): string {
  const { stageFile, geometryFile, path, arc, start, end } = placement;
  const speedOfLight = stage.speedOfLight ?? placement.speedOfLight;
  const layers = arc === 'sublayer' ? [stageFile, geometryFile] : [stageFile];
  const metadata = [
    ...(speedOfLight === undefined
      ? []
      : [`customLayerData = { dictionary slowlight = { double speedOfLight = ${speedOfLight} } }`]),
    ...(stage.defaultPrim === undefined ? [] : [`defaultPrim = ${JSON.stringify(stage.defaultPrim)}`]),
    `endTimeCode = ${Math.max(end, stage.endTimeCode ?? end)}`,
    `metersPerUnit = ${stage.metersPerUnit}`,
    `startTimeCode = ${Math.min(start, stage.startTimeCode ?? start)}`,
    `subLayers = [${layers.map((file) => `@${file}@`).join(', ')}]`,
    `timeCodesPerSecond = ${stage.timeCodesPerSecond}`,
    `upAxis = "${stage.upAxis}"`,
  ];
  const head = ['#usda 1.0', '(', ...metadata.map((line) => `    ${line}`), ')', ''];
  return [...head, ...(arc === 'payload' ? payloadLines(path, stage.ancestors, geometryFile) : [])].join('\n');
}

function payloadLines(path: string, existing: number, file: string): readonly string[] {
  const names = path.split('/').filter(Boolean);
  const leaf = names.at(-1) ?? '';
  const lines = names.slice(0, -1).flatMap((name, i) => {
    const indent = '    '.repeat(i);
    return [`${indent}${i < existing ? 'over' : 'def Xform'} "${name}"`, `${indent}{`];
  });
  const indent = '    '.repeat(names.length - 1);
  const prim = [
    `${indent}def Xform "${leaf}" (`,
    `${indent}    prepend payload = @${file}@</${leaf}>`,
    `${indent})`,
    `${indent}{`,
    `${indent}}`,
  ];
  const ends = names.slice(0, -1).map((_, i) => `${'    '.repeat(names.length - 2 - i)}}`);
  return [...lines, ...prim, ...ends, ''];
}
