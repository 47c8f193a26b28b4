import type { ParamValue } from '../../graph/document/document.ts';
import type { ParamSpec } from '../../graph/nodeType.ts';

export interface ParamProps<Spec extends ParamSpec = ParamSpec> {
  readonly spec: Spec;
  /** As set in the document; undefined: the default, or what the scene suggests. */
  readonly set: ParamValue | undefined;
  /** What holds now. */
  readonly value: ParamValue;
  /** For a text whose values come from the scene. */
  readonly choices?: readonly string[];
  /** The node that says what it is, where an edge drives it. */
  readonly drivenBy?: string;
  /** `gesture`: part of one continuous action. */
  readonly onChange: (value: ParamValue | undefined, gesture?: string) => void;
  readonly onGestureEnd: () => void;
}
