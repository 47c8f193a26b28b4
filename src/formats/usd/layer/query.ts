import type { Layer, MetadataValue, PrimSpec } from './layer.ts';
import { splitProperty } from './paths.ts';

export function metadataNumber(metadata: ReadonlyMap<string, MetadataValue>, key: string): number | undefined {
  const value = metadata.get(key);
  return value && 'data' in value && typeof value.data === 'number' ? value.data : undefined;
}

/** Time code at which a stage starts or ends; `startFrame` and `endFrame` are their former names, which OpenUSD reads too. */
export const stageTimeCode = (
  metadata: ReadonlyMap<string, MetadataValue>,
  which: 'start' | 'end',
): number | undefined => metadataNumber(metadata, `${which}TimeCode`) ?? metadataNumber(metadata, `${which}Frame`);

export function metadataText(metadata: ReadonlyMap<string, MetadataValue>, key: string): string | undefined {
  const value = metadata.get(key);
  return value && 'data' in value && typeof value.data === 'string' ? value.data : undefined;
}

/** The prim at an absolute path. */
export function primAt(layer: Layer, path: string): PrimSpec | undefined {
  const names = path.split('/').filter(Boolean);
  let prim = layer.rootPrims.get(names[0] ?? '');
  for (const name of names.slice(1)) prim = prim?.children.get(name);
  return prim;
}

/** The prims along a path, from the root down, as far as they are there. */
export function primsAlong(layer: Layer, path: string): PrimSpec[] {
  const found: PrimSpec[] = [];
  let { rootPrims: children } = layer;
  for (const name of path.split('/').filter(Boolean)) {
    const prim = children.get(name);
    if (!prim) break;
    found.push(prim);
    children = prim.children;
  }
  return found;
}

/** The prims above a path, from the root down. */
export const ancestorsOf = (layer: Layer, path: string): PrimSpec[] =>
  primsAlong(layer, path.slice(0, path.lastIndexOf('/')));

/** Targets of a relationship, or sources of a connection: its list op applied to an empty list. */
export function targetsOf(prim: PrimSpec, name: string): readonly string[] {
  const property = prim.properties.get(name);
  const op = property?.kind === 'relationship' ? property.targets : property?.connections;
  if (!op) return [];
  return op.explicit ?? [...(op.prepended ?? []), ...(op.added ?? []), ...(op.appended ?? [])];
}

/** The prim and the property that a connection or a relationship to a property leads to. */
export function propertyAt(layer: Layer, path: string): readonly [PrimSpec, string] | undefined {
  const [primPath, property] = splitProperty(path);
  const prim = primAt(layer, primPath);
  return prim && property !== '' ? [prim, property] : undefined;
}

export function isActive(prim: PrimSpec): boolean {
  const active = prim.metadata.get('active');
  return active?.type !== 'bool' || active.data;
}
