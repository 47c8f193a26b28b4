import { Button, Group, Select, Text } from '@mantine/core';
import { type ReactNode, useId, useState } from 'react';
import type { EventMark } from '../../graph/document/document.ts';
import { type Message, msg } from '../../messages/message.ts';
import { formatLength, formatNumber, formatSeconds } from '../format.ts';
import { useTexts } from '../language/languageStore.ts';
import { useEditor } from '../state/context.tsx';
import { SignButton } from './SignButton.tsx';
import { compareMarks, type MarkDifference, marksCsv } from './stopwatch.ts';

interface StopwatchProps {
  readonly marks: readonly EventMark[];
  /** [m/s] */
  readonly speedOfLight: number;
  readonly onChange: (marks: readonly EventMark[]) => void;
}

/** Marked events, and what lies between two of them. */
export function Stopwatch({ marks, speedOfLight, onChange }: StopwatchProps): ReactNode {
  const { t } = useTexts();
  if (marks.length === 0) return null;
  return (
    <>
      <table className="sl-clocks">
        <caption>{t(msg`Marked events`)}</caption>
        <thead>
          <tr>
            <th scope="col">{t(msg`Event`)}</th>
            <th scope="col">{t(msg`Its clock`)}</th>
            <th scope="col">{t(msg`World time`)}</th>
            <td />
          </tr>
        </thead>
        <tbody>
          {marks.map((mark) => (
            <tr key={mark.name}>
              <th scope="row">
                <MarkName
                  name={mark.name}
                  taken={(name) => marks.some((other) => other !== mark && other.name === name)}
                  onChange={(name) => onChange(marks.map((other) => (other === mark ? { ...mark, name } : other)))}
                />
                <small>{mark.thing ?? t(msg`Ship`)}</small>
              </th>
              <td>{formatSeconds(mark.properTime)}</td>
              <td>{formatSeconds(mark.time)}</td>
              <td>
                <SignButton
                  sign="×"
                  title={msg`Remove: ${mark.name}`}
                  act={() => onChange(marks.filter((other) => other !== mark))}
                />
              </td>
            </tr>
          ))}
        </tbody>
      </table>
      {marks.length > 1 && <Between marks={marks} speedOfLight={speedOfLight} />}
      <CopyButtons marks={marks} />
    </>
  );
}

/** [characters] */
const LONGEST_NAME = 40;

interface MarkNameProps {
  readonly name: string;
  /** Whether another event has a name. */
  readonly taken: (name: string) => boolean;
  readonly onChange: (name: string) => void;
}

/** A name that can be written over: leaving the field or Enter accepts it, Escape cancels. A name of another event is not accepted, and left with the field. */
function MarkName({ name, taken, onChange }: MarkNameProps): ReactNode {
  const { t } = useTexts();
  const problem = useId();
  const [typed, setTyped] = useState<string>();
  const written = typed?.trim();
  const isTaken = written !== undefined && taken(written);
  const commit = () => {
    if (written && written !== name && !isTaken) onChange(written);
    setTyped(undefined);
  };
  return (
    <>
      <input
        className="sl-clocks-rename"
        aria-label={t(msg`Name of the event ${name}`)}
        aria-invalid={isTaken}
        aria-describedby={isTaken ? problem : undefined}
        maxLength={LONGEST_NAME}
        size={1}
        spellCheck={false}
        value={typed ?? name}
        onChange={(event) => setTyped(event.currentTarget.value)}
        onBlur={commit}
        onKeyDown={({ key }) => {
          if (key === 'Enter' && !isTaken) commit();
          if (key === 'Escape') setTyped(undefined);
        }}
      />
      {isTaken && (
        <span id={problem} className="sl-clocks-problem" role="alert">
          {t(msg`Another event has this name`)}
        </span>
      )}
    </>
  );
}

const SEPARATENESS: Readonly<Record<MarkDifference['separateness'], Message>> = {
  timelike: msg`timelike: one can be at both`,
  lightlike: msg`lightlike: light goes from one to the other`,
  spacelike: msg`spacelike: none can be at both`,
  same: msg`they are one event`,
};

/** Of the last two, unless others are chosen. */
function Between({ marks, speedOfLight }: Omit<StopwatchProps, 'onChange'>): ReactNode {
  const { t } = useTexts();
  const [chosen, setChosen] = useState<Partial<Record<'from' | 'to', string>>>({});
  const named = (name: string | undefined) => marks.find((mark) => mark.name === name);
  const from = named(chosen.from) ?? marks.at(-2)!;
  const to = named(chosen.to) ?? marks.at(-1)!;
  const { dt, distance, dOwn, dTau, interval, separateness, dtObserver } = compareMarks(from, to, speedOfLight);
  const rows: readonly (readonly [Message, string])[] = [
    [msg`World time between`, formatSeconds(dt)],
    [msg`Distance in the world`, formatLength(distance)],
    [msg`By the ship’s clock`, formatSeconds(dOwn)],
    ...(dTau === undefined || to.thing === undefined
      ? []
      : [[msg`By the clock at both`, formatSeconds(dTau)] as const]),
    [msg`Between them in your frame`, formatSeconds(dtObserver)],
    [msg`Interval Δx² − c²Δt²`, `${formatNumber(interval)} m²`],
  ];
  const data = marks.map(({ name, thing }) => ({ value: name, label: `${name} · ${thing ?? t(msg`Ship`)}` }));
  return (
    <>
      <Group gap="xs" grow wrap="nowrap">
        {[['from', msg`From`, from] as const, ['to', msg`To`, to] as const].map(([end, label, { name }]) => (
          <Select
            key={end}
            size="xs"
            label={t(label)}
            allowDeselect={false}
            data={data}
            value={name}
            onChange={(value) => value !== null && setChosen({ ...chosen, [end]: value })}
          />
        ))}
      </Group>
      <table className="sl-clocks">
        <tbody>
          {rows.map(([title, value]) => (
            <tr key={title.template}>
              <th scope="row">{t(title)}</th>
              <td>{value}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <Text size="xs">{t(SEPARATENESS[separateness])}</Text>
    </>
  );
}

function CopyButtons({ marks }: Pick<StopwatchProps, 'marks'>): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const copy = (text: string) =>
    navigator.clipboard.writeText(text).then(
      () => editor.notify({ kind: 'info', text: msg`Copied ${marks.length} events` }),
      () => editor.notify({ kind: 'error', text: msg`The browser does not let this page copy` }),
    );
  return (
    <Group gap="xs">
      <Button size="compact-xs" variant="default" onClick={() => copy(marksCsv(marks))}>
        {t(msg`Copy as CSV`)}
      </Button>
      <Button size="compact-xs" variant="default" onClick={() => copy(JSON.stringify(marks, undefined, 2))}>
        {t(msg`Copy as JSON`)}
      </Button>
    </Group>
  );
}
