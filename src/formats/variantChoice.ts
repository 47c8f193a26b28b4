/** `/World/Car{paint}=red` → set and option of a `VariantSet`; undefined if malformed. */
export function parseVariantChoice(text: string): readonly [set: string, option: string] | undefined {
  const at = text.indexOf('=');
  return at > 0 && at < text.length - 1 ? [text.slice(0, at), text.slice(at + 1)] : undefined;
}

export const formatVariantChoice = (set: string, option: string): string => `${set}=${option}`;
