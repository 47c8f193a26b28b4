import type { Vec3 } from '../../../../math/vec3.ts';
import { listed, msg } from '../../../../messages/message.ts';
import type { PolygonValues } from '../../../../scene/mesh/polygons.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, numbersAt, textAt } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import { metadataText, targetsOf } from '../../layer/query.ts';
import type { StageContext } from '../context.ts';
import { type MeshElementCounts, primvarOf, valuesOnMesh } from '../primvars.ts';
import { type BoundMaterial, type DisplayColor, type MaterialTable, withDisplayColor } from './materialTable.ts';
import { mapCorners, transformUvs } from './uvs.ts';

/** Materials of a prim's faces, and the primvars they read. */
export interface PrimMaterials {
  /** Material index of faces without a subset. */
  readonly base: BoundMaterial;
  /** All its materials. */
  readonly materials: readonly number[];
  /** Index of the material that shows the displayColor of an enclosing instancer, if the prim has none of its own. */
  readonly displayColorMaterial: number | undefined;
  faceMaterials(faces: number): Uint32Array;
  uvs(prim: PrimSpec, topology: MeshElementCounts): PolygonValues | undefined;
  colors(prim: PrimSpec, topology: MeshElementCounts): PolygonValues | undefined;
}

/** Binding relationships; the nearest prim wins, unless an ancestor's binding is strongerThanDescendants. */
const BINDINGS = ['material:binding', 'material:binding:preview', 'material:binding:full'];

/** The bound material's path, given its parent's. */
export function materialBindingOf(prim: PrimSpec, inherited: MaterialBinding | undefined): MaterialBinding | undefined {
  if (inherited?.strong) return inherited;
  for (const name of BINDINGS) {
    const path = targetsOf(prim, name)[0];
    if (path === undefined) continue;
    const property = prim.properties.get(name)!;
    return { path, strong: metadataText(property.metadata, 'bindMaterialAs') === 'strongerThanDescendants' };
  }
  return inherited;
}
export interface MaterialBinding {
  readonly path: string;
  readonly strong: boolean;
}

const GREY: Vec3 = [0.5, 0.5, 0.5];

export async function primMaterialsOf(
  context: StageContext,
  table: MaterialTable,
  prim: PrimSpec,
  binding: MaterialBinding | undefined,
): Promise<PrimMaterials> {
  const display = displayColor(context, prim);
  const base = binding
    ? await table.bound(binding.path, prim.path, display)
    : withDisplayColor(await table.displayColorMaterial(display.color, display.opacity), display);
  const subsets = await subsetsOf(context, table, prim, binding, display);
  const used = [base, ...subsets.map((s) => s.material)];
  const isOpen = attributeOf(prim, DISPLAY_COLOR) === undefined && (!binding || base.colors?.name === 'displayColor');
  return {
    base,
    materials: used.map(({ index }) => index),
    displayColorMaterial: isOpen ? base.index : undefined,
    faceMaterials: (faces) => faceMaterials(base, subsets, faces),
    uvs: (mesh, topology) => uvsOf(context, mesh, topology, used, faceMaterials(base, subsets, topology.faces)),
    colors: (mesh, topology) => colorsOf(context, mesh, topology, used, faceMaterials(base, subsets, topology.faces)),
  };
}

/** The colours that the materials read; white on faces whose material reads none. */
function colorsOf(
  context: StageContext,
  prim: PrimSpec,
  topology: MeshElementCounts,
  used: readonly BoundMaterial[],
  materials: Uint32Array,
): PolygonValues | undefined {
  const reading = used.flatMap(({ index, colors }) => (colors ? [{ index, ...colors }] : []));
  const [first] = reading;
  if (!first) return undefined;
  const { name, fallback } = first;
  const other = reading.find((colors) => colors.name !== name);
  if (other) {
    const message = msg`its materials read colours ${name} and ${other.name}; the first is used for both`;
    report(context, 'warning', 'usd.primvar', prim.path, message);
  }
  const path = `primvars:${name}`;
  const primvar = primvarOf(prim, path, context.startCode);
  const found = primvar && valuesOnMesh(context, prim, path, primvar, 3, topology);
  const values: PolygonValues = found ?? { per: 'constant', values: Float32Array.from(fallback) };
  const read = new Set(reading.map(({ index }) => index));
  const counts = numbersAt(prim, 'faceVertexCounts', context.startCode);
  const points = numbersAt(prim, 'faceVertexIndices', context.startCode);
  if (used.every(({ index }) => read.has(index)) || !counts || !points) return values;
  return mapCorners(values, 3, points, counts, (face, color) => (read.has(materials[face]) ? color : WHITE));
}

const WHITE: Vec3 = [1, 1, 1];

const DISPLAY_COLOR = 'primvars:displayColor';

/** The constant displayColor; white if it varies, because colours are then per vertex. */
function displayColor(context: StageContext, prim: PrimSpec): DisplayColor {
  const colors = numbersAt(prim, DISPLAY_COLOR, context.startCode);
  const opacity = numbersAt(prim, 'primvars:displayOpacity', context.startCode)?.[0] ?? 1;
  const varies = (colors?.length ?? 0) > 3;
  const color: Vec3 = varies ? [1, 1, 1] : colors?.length === 3 ? [colors[0], colors[1], colors[2]] : GREY;
  return { color, opacity, varies };
}

interface FaceSubset {
  readonly material: BoundMaterial;
  readonly faces: ArrayLike<number>;
}

async function subsetsOf(
  context: StageContext,
  table: MaterialTable,
  prim: PrimSpec,
  binding: MaterialBinding | undefined,
  display: DisplayColor,
): Promise<FaceSubset[]> {
  const subsets: FaceSubset[] = [];
  for (const child of prim.children.values()) {
    if (child.typeName !== 'GeomSubset' || child.specifier !== 'def') continue;
    const own = materialBindingOf(child, binding?.strong ? binding : undefined);
    if (!own) continue;
    if ((textAt(child, 'elementType', undefined) ?? 'face') !== 'face') {
      report(
        context,
        'warning',
        'usd.subset',
        child.path,
        msg`only subsets of faces can have a material; it is left out`,
      );
      continue;
    }
    const faces = numbersAt(child, 'indices', context.startCode) ?? [];
    subsets.push({ material: await table.bound(own.path, child.path, display), faces });
  }
  return subsets;
}

function faceMaterials(base: BoundMaterial, subsets: readonly FaceSubset[], faces: number): Uint32Array {
  const out = new Uint32Array(faces).fill(base.index);
  for (const { material, faces: own } of subsets)
    for (let i = 0; i < own.length; i++) if (own[i] >= 0 && own[i] < faces) out[own[i]] = material.index;
  return out;
}

/** The uv primvar that the materials read, else `st`, else any other. */
function uvsOf(
  context: StageContext,
  prim: PrimSpec,
  topology: MeshElementCounts,
  used: readonly BoundMaterial[],
  materials: Uint32Array,
): PolygonValues | undefined {
  const requested = new Set(used.flatMap((m) => m.uv?.name ?? []));
  const name = [...requested, 'st', ...uvPrimvars(prim)].find((n) => attributeOf(prim, `primvars:${n}`));
  if (name === undefined) {
    if (requested.size > 0) {
      const message = msg`its material reads uvs '${[...requested].join("', '")}', which it does not have`;
      report(context, 'warning', 'usd.uv', prim.path, message);
    }
    return undefined;
  }
  if (requested.size > 1) {
    const message = msg`its materials use uvs ${listed([...requested])}; ${name} is used`;
    report(context, 'warning', 'usd.uv', prim.path, message);
  }
  const primvar = primvarOf(prim, `primvars:${name}`, context.startCode);
  const values = primvar && valuesOnMesh(context, prim, `primvars:${name}`, primvar, 2, topology);
  if (!values || !used.some((m) => m.uv?.transform)) return values;
  const points = numbersAt(prim, 'faceVertexIndices', context.startCode)!;
  const counts = numbersAt(prim, 'faceVertexCounts', context.startCode)!;
  const byIndex = new Map(used.map((m) => [m.index, m.uv?.transform]));
  return transformUvs(values, points, counts, (face) => byIndex.get(materials[face]));
}

function uvPrimvars(prim: PrimSpec): string[] {
  const names: string[] = [];
  for (const property of prim.properties.values())
    if (property.kind === 'attribute' && /^(texCoord2[fhd]|float2|Vec2f)\[\]$/.test(property.typeName))
      if (property.name.startsWith('primvars:')) names.push(property.name.slice('primvars:'.length));
  return names;
}
