import type { LocalizedText, Message } from '../messages/message.ts';

/** A place in a picture [px], from its top left. */
export type PixelPoint = readonly [x: number, y: number];

/** What a mark stands for, which decides its colour. A number is that of a line of the scene or of a body. */
export type MarkRole = 'frame' | 'axis' | 'otherAxis' | 'observer' | 'pastCone' | 'futureCone' | 'slice' | number;

/** What a diagram consists of, in the order of drawing. */
export type Mark =
  | {
      /** Lines that belong together, each through its points. */
      readonly kind: 'lines';
      readonly role: MarkRole;
      readonly lines: readonly (readonly PixelPoint[])[];
      /** [px] */
      readonly width: number;
      /** Absent: as lines of this role are. */
      readonly dashed?: boolean;
    }
  | { readonly kind: 'area'; readonly role: MarkRole; readonly outline: readonly PixelPoint[] }
  | {
      readonly kind: 'dot';
      readonly role: MarkRole;
      readonly at: PixelPoint;
      /** Filled: an emission event; hollow: an event of the slice. */
      readonly filled: boolean;
      /** Name for people. */
      readonly title?: LocalizedText;
    }
  | {
      readonly kind: 'text';
      readonly role: MarkRole;
      readonly at: PixelPoint;
      readonly text: LocalizedText;
      readonly anchor: 'start' | 'middle' | 'end';
    };

/** A diagram as data. */
export interface Diagram {
  /** [px] */
  readonly width: number;
  /** [px] */
  readonly height: number;
  readonly title: Message;
  /** For those who do not see it. */
  readonly description: Message;
  readonly marks: readonly Mark[];
}
