import { Group, Popover, Text, Tooltip, UnstyledButton } from '@mantine/core';
import { IconEye, IconGauge, IconLockOpen, IconPlane, IconSteeringWheel } from '@tabler/icons-react';
import { lazy, type ReactNode, Suspense, useState } from 'react';
import type { Lock } from '../../flight/arc.ts';
import { type GraphDocument, own } from '../../graph/document/document.ts';
import { isParamActive, isUnphysical, resolveParams } from '../../graph/nodeType.ts';
import { type LocalizedText, listed, type Message, msg } from '../../messages/message.ts';
import { nodeLibrary } from '../../nodes/library.ts';
import { formatBeta, formatCount, formatNumber, formatSeconds, formatSpeed } from '../format.ts';
import { useTexts } from '../language/languageStore.ts';
import { useServices } from '../services.tsx';
import { useEditor, useEditorState, useTelemetry } from '../state/context.tsx';

const LOCK_ICONS = { free: IconLockOpen, look: IconEye, fly: IconPlane } as const satisfies Record<Lock, unknown>;

const LOCK_TEXTS: Readonly<Record<Lock, { readonly title: Message; readonly help: Message }>> = {
  free: { title: msg`Free`, help: msg`You move and see the effects of your velocity.` },
  look: { title: msg`Look`, help: msg`You have a velocity but stay in place.` },
  fly: { title: msg`Fly`, help: msg`You move, but the picture is that of someone at rest.` },
};

/** Loaded when it is opened. */
const FlightDeck = lazy(() => import('../flight/deck/FlightDeck.tsx'));

/** Lock, speed, γ and speed of light; then backend, quality and the observer's proper time. */
export function StatusBar(): ReactNode {
  const { t } = useTexts();
  return (
    <Group component="footer" className="sl-status" gap={0} wrap="nowrap" aria-label={t(msg`Status`)}>
      <LockButton />
      <CruiseButton />
      <FlightButton />
      <Unphysical />
      <Speed />
      <div className="sl-spring" />
      <Clock />
      <Machine />
    </Group>
  );
}

function LockButton(): ReactNode {
  const { t } = useTexts();
  const { observerController } = useServices();
  const lock = useEditorState((state) => state.lock);
  const Icon = LOCK_ICONS[lock];
  return (
    <Tooltip label={t(LOCK_TEXTS[lock].help)} openDelay={300}>
      <UnstyledButton
        className="sl-status-item sl-status-button"
        aria-label={`${t(msg`Lock`)}: ${t(LOCK_TEXTS[lock].title)}`}
        data-lock={lock}
        onClick={() => observerController.cycleLock()}
      >
        <Icon size={14} />
        <Text size="xs" fw={600}>
          {t(LOCK_TEXTS[lock].title)}
        </Text>
      </UnstyledButton>
    </Tooltip>
  );
}

function CruiseButton(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const cruise = useEditorState((state) => state.cruise);
  return (
    <Tooltip label={t(msg`Keep the velocity when you do not steer`)} openDelay={300}>
      <UnstyledButton
        className="sl-status-item sl-status-button"
        aria-pressed={cruise}
        onClick={() => editor.update({ cruise: !cruise })}
      >
        <IconGauge size={14} opacity={cruise ? 1 : 0.35} />
        <Text size="xs" c={cruise ? undefined : 'dimmed'}>
          {t(msg`Cruise`)}
        </Text>
      </UnstyledButton>
    </Tooltip>
  );
}

/** Opens the flight deck: modes, recording, replay. */
function FlightButton(): ReactNode {
  const { t } = useTexts();
  const title = useEditorState(({ flightMode }) => flightMode);
  const [opened, setOpened] = useState(false);
  return (
    <Popover opened={opened} onChange={setOpened} position="top-start" shadow="md" trapFocus>
      <Popover.Target>
        <UnstyledButton
          className="sl-status-item sl-status-button"
          aria-label={`${t(msg`Flight`)}: ${t(title)}`}
          onClick={() => setOpened(!opened)}
        >
          <IconSteeringWheel size={14} />
          <Text size="xs" className="sl-status-more">
            {t(title)}
          </Text>
        </UnstyledButton>
      </Popover.Target>
      <Popover.Dropdown>
        <Suspense>
          <FlightDeck />
        </Suspense>
      </Popover.Dropdown>
    </Popover>
  );
}

interface ItemProps {
  readonly label: string;
  /** Precedes the value, where space allows. */
  readonly more?: string;
  readonly value: string;
  readonly id: string;
}

function Item({ label, more, value, id }: ItemProps): ReactNode {
  return (
    <div className="sl-status-item" data-status={id}>
      <Text size="xs" c="dimmed" className="sl-status-label">
        {label}
      </Text>
      <Text size="xs" className="sl-figure">
        {more && <span className="sl-status-more">{more}</span>}
        {value}
      </Text>
    </div>
  );
}

function Speed(): ReactNode {
  const { t } = useTexts();
  const beta = useTelemetry((live) => live.beta);
  const gamma = useTelemetry((live) => live.gamma);
  const c = useEditorState((state) => state.picture?.speedOfLight);
  return (
    <>
      <Item
        id="speed"
        label={t(msg`Speed`)}
        more={c === undefined ? undefined : `${formatSpeed(beta * c)} · `}
        value={c ? `${formatBeta(beta)} c` : '–'}
      />
      <Item id="gamma" label={t(msg`Lorentz factor`)} value={`γ = ${formatNumber(gamma, 4)}`} />
      <Item id="c" label={t(msg`Speed of light`)} value={c ? `c = ${formatSpeed(c)}` : '–'} />
    </>
  );
}

/** Lists unphysical settings while they are active. */
function Unphysical(): ReactNode {
  const { t } = useTexts();
  const document = useEditorState((state) => state.history.document);
  const names = unphysical(document);
  const text = t(msg`${msg`Not physical`}: ${listed(names)}`);
  return names.length > 0 ? (
    <Text size="xs" fw={600} className="sl-unphysical" role="status" title={text} data-status="unphysical">
      {text}
    </Text>
  ) : null;
}

/** Titles of the active parameters with unphysical values. */
const unphysical = ({ nodes }: GraphDocument): LocalizedText[] =>
  Object.values(nodes).flatMap((node) => {
    const type = own(nodeLibrary, node.type);
    if (!type) return [];
    const params = resolveParams(type, node.params);
    return Object.entries(type.params).flatMap(([name, spec]) =>
      isUnphysical(spec, params[name]!) && isParamActive(type, spec, params) ? [spec.title] : [],
    );
  });

function Clock(): ReactNode {
  const { t } = useTexts();
  const properTime = useTelemetry((live) => live.properTime);
  return <Item id="own-time" label={t(msg`Proper time`)} value={`τ = ${formatSeconds(properTime)}`} />;
}

/** Error below which the tessellation is not reported [px]. */
const MAX_UNNOTICED_ERROR = 0.5;

const BACKENDS = { webgpu: 'WebGPU', webgl: 'WebGL 2' } as const;

function Machine(): ReactNode {
  const { t } = useTexts();
  const graphics = useEditorState((state) => state.graphics);
  const triangles = useTelemetry((live) => live.triangles);
  const tolerance = useTelemetry((live) => live.tolerance);
  const waiting = useTelemetry((live) => live.waiting);
  const starting = graphics === 'starting' ? t(msg`starting…`) : t(msg`recovering…`);
  const name = graphics === 'webgpu' || graphics === 'webgl' ? BACKENDS[graphics] : starting;
  return (
    <>
      <Text size="xs" className="sl-status-item sl-figure" c="dimmed" data-status="triangles">
        {t(msg`${formatCount(triangles)} triangles`)}
        {tolerance > MAX_UNNOTICED_ERROR && ` · ${t(msg`error up to ${formatCount(Math.ceil(tolerance))} px`)}`}
        {waiting && ` · ${t(msg`reading samples…`)}`}
      </Text>
      <Text size="xs" className="sl-status-item" c="dimmed" data-status="backend">
        {name}
      </Text>
      <ShadingButton />
    </>
  );
}

const SHADINGS = { forward: msg`Forward shading`, deferred: msg`Deferred shading` } as const;

/** Says how the picture is shaded; pressed: always with a G-buffer, for comparison. */
function ShadingButton(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const choice = useEditorState((state) => state.shading);
  const shading = useTelemetry((live) => live.shading);
  const help = msg`Forward: light is computed while surfaces are drawn. Deferred: of a G-buffer, which ambient occlusion and effects read. Click: always deferred.`;
  return (
    <Tooltip label={t(help)} openDelay={300} multiline w={280}>
      <UnstyledButton
        className="sl-status-item sl-status-button"
        data-status="shading"
        data-shading={shading}
        aria-pressed={choice === 'deferred'}
        onClick={() => editor.update({ shading: choice === 'auto' ? 'deferred' : 'auto' })}
      >
        <Text size="xs" c="dimmed">
          {t(SHADINGS[shading])}
        </Text>
      </UnstyledButton>
    </Tooltip>
  );
}
