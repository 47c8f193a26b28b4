import { attributeOf, sampleTimes, type TimeCode, textOf, valueAt } from '../../layer/attributes.ts';
import type { Layer, PrimSpec, Value } from '../../layer/layer.ts';
import { metadataText, propertyAt, targetsOf } from '../../layer/query.ts';

/** The value of a shader input, or the shader output that it is connected to. */
export interface ResolvedInput {
  readonly value?: Value;
  /** Metadata of the attribute that has the value. */
  readonly colorSpace?: string;
  readonly shader?: PrimSpec;
  /** `rgb`, `r`, `a` …, without `outputs:`. */
  readonly output?: string;
}

/** Maximum length of a connection chain. */
const MAX_HOPS = 32;

/** Follows connections from a property of a shader, node graph or material to its source. */
export function resolveInput(layer: Layer, prim: PrimSpec, property: string, time: TimeCode): ResolvedInput {
  let [at, name] = [prim, property];
  for (let hop = 0; hop < MAX_HOPS; hop++) {
    const source = targetsOf(at, name)[0];
    if (source === undefined) return valueInput(at, name, time);
    const next = propertyAt(layer, source);
    if (!next) return valueInput(at, name, time);
    [at, name] = next;
    if (at.typeName === 'Shader' && name.startsWith('outputs:')) return { shader: at, output: name.slice(8) };
  }
  return {};
}

function valueInput(prim: PrimSpec, name: string, time: TimeCode): ResolvedInput {
  const attribute = attributeOf(prim, name);
  const value = valueAt(attribute, time);
  if (!attribute || !value) return {};
  const colorSpace = metadataText(attribute.metadata, 'colorSpace');
  return { value, ...(colorSpace !== undefined && { colorSpace }) };
}

/** Whether a shader's inputs change with time. */
export const isAnimated = (shader: PrimSpec): boolean =>
  [...shader.properties.values()].some((p) => p.kind === 'attribute' && sampleTimes(p).length > 0);

export const shaderId = (shader: PrimSpec): string => textOf(valueAt(attributeOf(shader, 'info:id'), undefined)) ?? '';
