import { Tooltip } from '@mantine/core';
import { IconAlertTriangle, IconEyeOff, IconHourglass, IconSitemap } from '@tabler/icons-react';
import type { NodeProps } from '@xyflow/react';
import { memo, type ReactNode, useContext } from 'react';
import type { Point } from '../../graph/commands.ts';
import { GROUP } from '../../graph/structure.ts';
import { writes } from '../../nodes/writers.ts';
import { useTexts } from '../i18n/i18n.ts';
import { SaveFileMark } from '../saving/SaveFileButton.tsx';
import { useStudio } from '../state/context.tsx';
import { contextOf, enter } from './actions.ts';
import { flatName, pathIn, useCanvas } from './canvas.ts';
import type { Face, Row, SocketFace } from './face.ts';
import { BARE, FarPixel, farTitle, LINE_HEIGHT } from './far.ts';
import type { CardNode } from './flow.ts';
import { NodePicture } from './NodePicture.tsx';
import { NodeWork } from './NodeWork.tsx';
import { SocketMark } from './Socket.tsx';
import { titleRoom } from './shape.ts';
import { Words } from './Words.tsx';

const NONE: ReadonlySet<string> = new Set();

/** While an edge is drawn, the node's sockets that it fits; else undefined. */
function useFits(id: string): ReadonlySet<string> | undefined {
  return useCanvas(({ fits }) => fits && (fits.get(id) ?? NONE));
}

/** A node: what it is called, its sockets, what of its parameters is set, what it made, and what is wrong. */
export const NodeCard = memo(function NodeCard({ data: { face, reach } }: NodeProps<CardNode>): ReactNode {
  const fits = useFits(face.id);
  const pixel = useContext(FarPixel);
  return (
    <article
      className="sl-node"
      data-category={face.category}
      data-muted={face.muted || undefined}
      data-collapsed={face.collapsed || undefined}
      data-picture={(!face.collapsed && face.picture) || undefined}
      data-problem={face.problem ? 'error' : undefined}
      data-unfit={(fits && fits.size === 0) || undefined}
    >
      <Head face={face} />
      {pixel !== undefined && <FarWords face={face} reach={reach} pixel={pixel} />}
      {face.collapsed ? <CollapsedSockets face={face} /> : <Body face={face} fits={fits} />}
    </article>
  );
});

function Head({ face }: { readonly face: Face }): ReactNode {
  const { any, t, said } = useTexts();
  return (
    <header className="sl-node-head">
      {face.type === GROUP && <EnterButton id={face.id} />}
      <span className="sl-node-title" title={face.kind && `${any(face.title)} (${any(face.kind)})`}>
        {any(face.title)}
      </span>
      <NodeWork id={face.id} />
      {!face.muted && writes(face.type) && <SaveMark id={face.id} />}
      {face.muted && <IconEyeOff size={14} aria-label={t('graph.muted')} />}
      {face.problem ? (
        <Tooltip label={`${said(face.problem.place)}: ${said(face.problem.message)}`} multiline maw={340} withinPortal>
          <span className="sl-node-problem">
            <IconAlertTriangle size={15} aria-hidden />
          </span>
        </Tooltip>
      ) : (
        face.blocked && <IconHourglass size={14} aria-label={t('graph.waits')} />
      )}
    </header>
  );
}

interface FarWordsProps {
  readonly face: Face;
  readonly reach: Point;
  readonly pixel: number;
}

/** What is shown of a node from afar: its title, in the middle of it, or above its picture. */
function FarWords({ face, reach, pixel }: FarWordsProps): ReactNode {
  const { any } = useTexts();
  const room = titleRoom(face, pixel <= BARE);
  const set = farTitle(any(face.title), room, reach, pixel);
  if (!set) return null;
  const [x, y] = set.reach;
  const place = { left: -x, right: -x, top: -y, height: room[1] + 2 * y };
  return (
    <div className="sl-far" style={{ ...place, fontSize: set.size, lineHeight: LINE_HEIGHT }} aria-hidden>
      <span style={{ WebkitLineClamp: set.lines }}>{set.text}</span>
    </div>
  );
}

/** Hands over the file that the node asks for. */
function SaveMark({ id }: { readonly id: string }): ReactNode {
  const studio = useStudio();
  const flat = useCanvas(({ path }) => flatName(pathIn(studio.store.getState().history.document, path), id));
  return <SaveFileMark node={flat} />;
}

function EnterButton({ id }: { readonly id: string }): ReactNode {
  const { t } = useTexts();
  const studio = useStudio();
  const open = () => {
    const context = contextOf(studio);
    if (context) enter(context, id);
  };
  return (
    <button
      type="button"
      className="sl-node-enter nodrag"
      tabIndex={-1}
      aria-label={t('graph.enter')}
      title={t('graph.enter')}
      onClick={open}
    >
      <IconSitemap size={14} />
    </button>
  );
}

/** All at one place, only for edges to end at. */
const CollapsedSockets = ({ face }: { readonly face: Face }): ReactNode =>
  face.rows.flatMap(({ input, output }) => [
    input && <SocketMark key={`in ${input.name}`} side="inputs" socket={input} closed unfit={false} />,
    output && <SocketMark key={`out ${output.name}`} side="outputs" socket={output} closed unfit={false} />,
  ]);

function Body({ face, fits }: { readonly face: Face; readonly fits?: ReadonlySet<string> }): ReactNode {
  const { t } = useTexts();
  return (
    <>
      {(face.rows.length > 0 || face.more > 0) && (
        <div className="sl-node-body">
          {face.rows.map((row, i) => (
            // biome-ignore lint/suspicious/noArrayIndexKey: rows have no name of their own
            <RowLine key={i} row={row} fits={fits} />
          ))}
          {face.more > 0 && <div className="sl-node-row sl-node-more">{t('graph.more', { count: face.more })}</div>}
        </div>
      )}
      {face.picture && <NodePicture face={face} />}
      {face.tells && (
        <footer className="sl-node-foot">{face.preview ? <Words of={face.preview} /> : <span>–</span>}</footer>
      )}
    </>
  );
}

function RowLine({
  row: { input, output, title, value },
  fits,
}: {
  readonly row: Row;
  readonly fits?: ReadonlySet<string>;
}) {
  const { any, t } = useTexts();
  const unfit = (key: string) => fits !== undefined && !fits.has(key);
  return (
    <div className="sl-node-row" data-param={title ? true : undefined}>
      {input && <SocketMark side="inputs" socket={input} closed={false} unfit={unfit(`inputs ${input.name}`)} />}
      <span className="sl-node-label">{title ? any(title) : input && <SocketWords socket={input} />}</span>
      {title && <span className="sl-node-value">{value ? <Words of={value} /> : <em>{t('graph.driven')}</em>}</span>}
      {output && (
        <>
          <span className="sl-node-label sl-node-out">
            <SocketWords socket={output} />
          </span>
          <SocketMark side="outputs" socket={output} closed={false} unfit={unfit(`outputs ${output.name}`)} />
        </>
      )}
    </div>
  );
}

function SocketWords({ socket }: { readonly socket: SocketFace }): ReactNode {
  const { any } = useTexts();
  return (
    <>
      {any(socket.title)}
      {socket.number !== undefined && <span className="sl-node-number"> {socket.number}</span>}
    </>
  );
}

/** A bend in an edge. */
export const RerouteDot = memo(function RerouteDot({ data: { face } }: NodeProps<CardNode>): ReactNode {
  const fits = useFits(face.id);
  const { input, output } = face.rows[0] ?? {};
  return (
    <div className="sl-dot" data-muted={face.muted || undefined}>
      {input && <SocketMark side="inputs" socket={input} closed={false} unfit={fits?.has('inputs in') === false} />}
      {output && (
        <SocketMark side="outputs" socket={output} closed={false} unfit={fits?.has('outputs out') === false} />
      )}
    </div>
  );
});
