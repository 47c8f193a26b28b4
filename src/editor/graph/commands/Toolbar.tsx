import { ActionIcon, Group, Kbd, Tooltip } from '@mantine/core';
import {
  IconArrowsVertical,
  IconCommand,
  IconFocusCentered,
  IconHierarchy2,
  IconNote,
  IconPhoto,
  IconPlus,
  IconZoomIn,
  IconZoomOut,
} from '@tabler/icons-react';
import type { ReactNode } from 'react';
import { msg } from '../../../messages/message.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useEditor } from '../../state/context.tsx';
import { useCanvas } from '../canvas/canvasState.ts';
import { actionContext, GRAPH_ACTIONS } from './actions.ts';
import { formatKeyBinding } from './keyBindings.ts';

const BUTTONS: readonly (readonly [action: string, icon: ReactNode])[] = [
  ['add', <IconPlus key="add" size={17} />],
  ['note', <IconNote key="note" size={17} />],
  ['arrange', <IconHierarchy2 key="arrange" size={17} />],
  ['pictures', <IconPhoto key="pictures" size={17} />],
  ['fit', <IconFocusCentered key="fit" size={17} />],
  ['large', <IconArrowsVertical key="large" size={16} />],
  ['zoom-out', <IconZoomOut key="out" size={17} />],
  ['zoom-in', <IconZoomIn key="in" size={17} />],
];

/** Buttons for the most frequent actions. */
export function Toolbar(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const pictures = useCanvas((state) => state.pictures);
  return (
    <Group className="sl-graph-tools" gap={0} role="toolbar" aria-label={t(msg`Graph tools`)}>
      {BUTTONS.map(([id, icon]) => {
        const { title, keys, run } = GRAPH_ACTIONS.find((action) => action.id === id)!;
        const act = () => {
          const context = actionContext(editor);
          if (context) run(context);
        };
        return (
          <Tool
            key={id}
            label={t(title)}
            keys={keys[0] ? formatKeyBinding(keys[0]) : []}
            onClick={act}
            {...(id === 'pictures' && { pressed: pictures })}
          >
            {icon}
          </Tool>
        );
      })}
      <Tool
        label={t(msg`Search commands and nodes`)}
        keys={formatKeyBinding('Mod+K')}
        onClick={() => editor.update({ dialog: 'palette' })}
      >
        <IconCommand size={16} />
      </Tool>
    </Group>
  );
}

interface ToolProps {
  readonly label: string;
  readonly keys: readonly string[];
  readonly onClick: () => void;
  /** For a toggle: whether it is on. */
  readonly pressed?: boolean;
  readonly children: ReactNode;
}

function Tool({ label, keys, onClick, pressed, children }: ToolProps): ReactNode {
  const tip = (
    <Group gap={6} wrap="nowrap">
      {label} {keys.length > 0 && <Kbd size="xs">{keys.join(' ')}</Kbd>}
    </Group>
  );
  return (
    <Tooltip label={tip} openDelay={400}>
      <ActionIcon
        variant={pressed ? 'light' : 'subtle'}
        color={pressed ? undefined : 'gray'}
        size={30}
        aria-label={label}
        aria-pressed={pressed}
        onClick={onClick}
      >
        {children}
      </ActionIcon>
    </Tooltip>
  );
}
