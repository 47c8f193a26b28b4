import { EMPTY_MAP, type Layer, type PrimSpec } from './layer.ts';

/**
 * Paths as composition uses them: '' is the pseudo-root, `/A/B` a prim, `/A{set=variant}/B` what a variant says of it.
 * Names hold no '/', so that the parent is what comes before the last one.
 */
export const parentOf = (path: string): string => path.slice(0, path.lastIndexOf('/'));

export const nameOf = (path: string): string => path.slice(path.lastIndexOf('/') + 1);

/** Whether `path` is `prefix` or below it: a child, property or variant. */
export function hasPrefix(path: string, prefix: string): boolean {
  if (!path.startsWith(prefix)) return false;
  return path.length === prefix.length || '/.{'.includes(path[prefix.length]);
}

/** Whether a predicate holds for a path or an ancestor, nearest first. */
export function someAncestor(path: string, ask: (around: string) => boolean): boolean {
  for (let at = path; at !== ''; at = parentOf(at)) if (ask(at)) return true;
  return false;
}

/** The path without variant selections, as on the stage. */
export const stripVariants = (path: string): string => (path.includes('{') ? path.replaceAll(/\{[^}]*\}/g, '') : path);

/** The ancestor path `levels` up. */
export function ancestorPath(path: string, levels: number): string {
  let end = path.length;
  for (let i = levels; i > 0 && end > 0; i--) end = path.lastIndexOf('/', end - 1);
  return path.slice(0, end);
}

/** The number of names in a path. */
export function depthOf(path: string): number {
  let depth = 0;
  for (let i = 0; i < path.length; i++) if (path.charCodeAt(i) === 47) depth++;
  return depth;
}

/** `/A/B`, without a property, a variant or `..`. */
export const isPrimPath = (path: string): boolean => /^(\/[^/.{}[\]]+)+$/.test(path);

/** Valid names of variant sets and variants (SdfSchema, variant identifiers). */
export const isVariantName = (name: string): boolean => /^[\p{L}\p{N}_|.-]+$/u.test(name);

export const variantPath = (path: string, set: string, variant: string): string => `${path}{${set}=${variant}}`;

/** The last selection in a path that ends with one. */
export function selectionOf(path: string): readonly [set: string, variant: string] | undefined {
  const [, set, variant] = /\{([^{}=]*)=([^{}]*)\}$/.exec(path) ?? [];
  return set === undefined ? undefined : [set, variant];
}

/** The spec at a path. */
export function specAt(root: PrimSpec, path: string): PrimSpec | undefined {
  let spec: PrimSpec | undefined = root;
  for (const part of path.split('/').slice(1)) {
    const [name, ...selections] = part.split('{');
    spec = spec?.children.get(name);
    for (const selection of selections) {
      const [set, variant] = selection.slice(0, -1).split('=');
      spec = spec?.variantSets.get(set)?.get(variant);
    }
  }
  return spec;
}

/** The pseudo-root of a layer: its root prims as children. */
export function pseudoRoot({ rootPrims, rootOrder }: Layer): PrimSpec {
  const nothing = { metadata: EMPTY_MAP, properties: EMPTY_MAP, variantSets: EMPTY_MAP };
  const order = rootOrder ? { childOrder: rootOrder } : {};
  return { path: '/', name: '', specifier: 'def', typeName: '', children: rootPrims, ...nothing, ...order };
}
