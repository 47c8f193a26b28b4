import { CloseButton, VisuallyHidden } from '@mantine/core';
import { type CSSProperties, type ReactNode, type RefObject, useEffect, useRef, useState } from 'react';
import './inspect.css';
import { msg } from '../../messages/message.ts';
import type { WorldLine } from '../../physics/worldLines/worldLine.ts';
import { type MeasuredLengths, measureLengths } from '../../scene/inspection/measureLengths.ts';
import type { Scene } from '../../scene/types.ts';
import { useInputDevice } from '../flight/inputDevice.ts';
import { useTexts } from '../language/languageStore.ts';
import { useServices } from '../services.tsx';
import { useEditor } from '../state/context.tsx';
import type { EditorState } from '../state/editor.ts';
import type { PicturePosition } from '../viewport/legend/legendState.ts';
import { useFrames } from '../viewport/useFrames.ts';
import { isCenter, useAim } from './aim.ts';
import { type FigureRow, inspectionRows, inspectionSentence, lengthRows } from './inspectionTexts.ts';
import { type AimReading, lineOf, PointReader, pickPoint, type ReadPicture } from './pointReader.ts';
import { projectLine } from './projectLine.ts';

/** How long figures stay the same before they are read aloud [ms]. */
const SPOKEN_AFTER = 600;

interface PictureToolProps {
  readonly picture: RefObject<HTMLElement | null>;
}

/** The tool that is in use over the picture. */
export default function PictureTools({
  tool,
  picture,
}: PictureToolProps & { readonly tool: NonNullable<EditorState['tool']> }): ReactNode {
  return tool === 'inspect' ? <Inspect picture={picture} /> : <Measure picture={picture} />;
}

/** What is known of the point at the aim. */
function Inspect({ picture }: PictureToolProps): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const device = useInputDevice();
  const [reading, setReading] = useState<AimReading>();
  const reader = useRef<PointReader>(undefined);
  const aim = useAim(picture, { end: () => editor.update({ tool: undefined }) });
  useEffect(() => {
    const made = new PointReader(setReading);
    reader.current = made;
    return () => made.stop();
  }, []);
  // If the device was lost, the next generation reads.
  useFrames((shown, time) => void reader.current?.update(shown, aim(), time)?.catch(() => {}));
  if (!reading) return null;
  const { place, path, inspection, now } = reading;
  const spoken = inspection && path ? inspectionSentence(path, inspection, t) : (path ?? t(msg`sky`));
  return (
    <>
      {isCenter(place) && <div className="sl-crosshair" aria-hidden />}
      {device === 'touch' && !isCenter(place) && (
        <div className="sl-inspection-aim" style={{ left: percent(place[0]), top: percent(place[1]) }} aria-hidden />
      )}
      <Card place={place} title={path ?? t(msg`sky`)} rows={inspection ? inspectionRows(inspection, now, t) : []}>
        {inspection?.superluminal && (
          <p className="sl-inspection-mark">{t(msg`Seems faster than light, but is not`)}</p>
        )}
      </Card>
      {isCenter(place) && <Spoken text={spoken} />}
    </>
  );
}

/** Two points are chosen by clicks, or by Enter at the middle; then their lengths are shown, of every picture anew. */
function Measure({ picture }: PictureToolProps): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const { viewport } = useServices();
  const [points, setPoints] = useState<readonly MeasuredPoint[]>([]);
  const [shown, setShown] = useState<ShownMeasure>({ places: [], lengths: undefined, aim: [0.5, 0.5] });
  const [hint, setHint] = useState(msg`Choose a point: click, or press Enter for the middle of the picture`);
  const choose = async (place: PicturePosition) => {
    const context = viewport.besides?.();
    const point = context && (await pickPoint(context, place));
    const line = point && lineOf(point);
    if (!line)
      return setHint(point ? msg`This cannot be measured: its motion stays in its file` : msg`Nothing is there`);
    setHint(msg`Choose the other point`);
    setPoints((before) => {
      const kept = before.length === 1 && before[0]!.scene === point.scene ? before : [];
      return [...kept, { scene: point.scene, line }];
    });
  };
  const aim = useAim(picture, {
    choose: (place) => void choose(place).catch(() => {}),
    end: () => editor.update({ tool: undefined }),
  });
  useFrames((context) => {
    const ends = points.every(({ scene }) => scene === context.picture.scene) ? points : [];
    if (ends.length < points.length) setPoints([]);
    const next = measureShown(ends, context, aim());
    setShown((before) => (JSON.stringify(before) === JSON.stringify(next) ? before : next));
  });
  const [from, to] = shown.places;
  const { lengths } = shown;
  const rows = lengths ? lengthRows(lengths) : [];
  const anchor = to ?? from ?? shown.aim;
  return (
    <>
      {isMiddle(shown.aim) && <div className="sl-crosshair" aria-hidden />}
      <svg className="sl-measure" aria-hidden>
        {from && to && <line x1={percent(from[0])} y1={percent(from[1])} x2={percent(to[0])} y2={percent(to[1])} />}
        {shown.places.map(
          // biome-ignore lint/suspicious/noArrayIndexKey: the two ends have no other name
          (place, i) => place && <circle key={i} cx={percent(place[0])} cy={percent(place[1])} r={5} />,
        )}
      </svg>
      <Card place={anchor} title={lengths ? t(msg`Lengths`) : t(hint)} rows={rows} />
      <Spoken text={lengths ? rows.map(({ title, value }) => `${t(title)}: ${value}`).join('; ') : t(hint)} />
    </>
  );
}

interface MeasuredPoint {
  readonly scene: Scene;
  readonly line: WorldLine;
}

interface ShownMeasure {
  /** Of the chosen points; undefined where the picture does not show one. */
  readonly places: readonly (PicturePosition | undefined)[];
  readonly lengths: MeasuredLengths | undefined;
  readonly aim: PicturePosition;
}

function measureShown(
  points: readonly MeasuredPoint[],
  { renderer, view }: ReadPicture,
  aim: PicturePosition,
): ShownMeasure {
  const { viewPoint, settings } = view;
  const [a, b] = points;
  return {
    places: points.map(({ line }) => projectLine(line, viewPoint, settings, renderer)),
    lengths: a && b && measureLengths(a.line, b.line, viewPoint, settings.speedOfLight),
    aim,
  };
}

const percent = (share: number): string => `${100 * share}%`;
const isMiddle = ([x, y]: PicturePosition): boolean => x === 0.5 && y === 0.5;

interface CardProps {
  readonly place: PicturePosition;
  readonly title: string;
  readonly rows: readonly FigureRow[];
  readonly children?: ReactNode;
}

/** Beside a place of the picture, on the side where there is room. */
function Card({ place: [x, y], title, rows, children }: CardProps): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const device = useInputDevice();
  const within = (share: number): string => percent(Math.min(1, Math.max(0, share)));
  const side = { '--sl-x': within(x), '--sl-y': within(y) } as CSSProperties;
  return (
    <div
      className="sl-inspection"
      style={side}
      data-across={x < 0.5 ? 'right' : 'left'}
      data-along={y < 0.5 ? 'below' : 'above'}
      data-inspection
    >
      {device === 'touch' && (
        <CloseButton
          className="sl-inspection-close"
          aria-label={t(msg`Close`)}
          onClick={() => editor.update({ tool: undefined })}
        />
      )}
      <div className="sl-inspection-path">
        <bdi>{title}</bdi>
      </div>
      {rows.length > 0 && (
        <dl>
          {rows.map(({ title: name, value }) => (
            <Row key={name.template} name={t(name)} value={value} />
          ))}
        </dl>
      )}
      {children}
    </div>
  );
}

const Row = ({ name, value }: { readonly name: string; readonly value: string }): ReactNode => (
  <>
    <dt>{name}</dt>
    <dd>{value}</dd>
  </>
);

/** Reads a text aloud once it rests. */
function Spoken({ text }: { readonly text: string }): ReactNode {
  const [spoken, setSpoken] = useState('');
  useEffect(() => {
    const timer = setTimeout(() => setSpoken(text), SPOKEN_AFTER);
    return () => clearTimeout(timer);
  }, [text]);
  return (
    <VisuallyHidden component="output" aria-live="polite" data-spoken>
      {spoken}
    </VisuallyHidden>
  );
}
