import type { NumberParam } from '../../graph/nodeType.ts';
import type { LocalizedText } from '../../messages/message.ts';

/** A number parameter without bounds. */
export const numberParam = <const Title extends LocalizedText>(title: Title, value = 0) =>
  ({
    kind: 'number',
    title,
    default: value,
    min: -1e12,
    max: 1e12,
    step: 0.001,
    slider: false,
  }) as const satisfies NumberParam;
