import type { ParamValue } from '../../graph/document/document.ts';
import type { ParamSpec } from '../../graph/nodeType.ts';

export interface ParamProps<Spec extends ParamSpec = ParamSpec> {
  readonly spec: Spec;
  /** Value set in the document; undefined: the default, or what the scene suggests. */
  readonly set: ParamValue | undefined;
  /** What holds now. */
  readonly value: ParamValue;
  /** Values that the scene offers for a text parameter. */
  readonly choices?: readonly string[];
  /** Title of the node whose edge drives it. */
  readonly drivenBy?: string;
  /** `gesture`: key of a continuous interaction, whose changes are one undo step. */
  readonly onChange: (value: ParamValue | undefined, gesture?: string) => void;
  readonly onGestureEnd: () => void;
}
