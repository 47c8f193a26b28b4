import { Group, Kbd, Text, TextInput } from '@mantine/core';
import { IconSearch } from '@tabler/icons-react';
import { type KeyboardEvent, type ReactNode, useEffect, useId, useRef, useState } from 'react';
import { msg } from '../../../messages/message.ts';
import { useTexts } from '../../language/languageStore.ts';
import { type QuickPickItem, rankItems } from './ranking.ts';

interface QuickPickProps {
  readonly label: string;
  readonly items: readonly QuickPickItem[];
  readonly onChoose: (item: QuickPickItem) => void;
  readonly onClose: () => void;
}

/** A text field with a filtered list: arrow keys select, Enter chooses. */
export function QuickPick({ label, items, onChoose, onClose }: QuickPickProps): ReactNode {
  const { t } = useTexts();
  const id = useId();
  const [query, setQuery] = useState('');
  const [at, setAt] = useState(0);
  const found = rankItems(items, query);
  const place = Math.min(at, found.length - 1);
  const list = useRef<HTMLDivElement>(null);
  useEffect(() => {
    list.current?.querySelector(`[data-place="${place}"]`)?.scrollIntoView({ block: 'nearest' });
  }, [place]);
  const onKeyDown = (event: KeyboardEvent) => {
    event.stopPropagation();
    const step = STEPS[event.key];
    if (event.key === 'Escape') onClose();
    else if (event.key === 'Enter') {
      const item = found[place];
      if (item) onChoose(item);
    } else if (step !== undefined) setAt(Math.max(0, Math.min(found.length - 1, place + step)));
    else return;
    event.preventDefault();
  };
  return (
    <div className="sl-finder">
      <TextInput
        size="sm"
        data-autofocus
        aria-label={label}
        placeholder={label}
        leftSection={<IconSearch size={15} />}
        role="combobox"
        aria-expanded
        aria-controls={`${id}-list`}
        aria-activedescendant={found.length > 0 ? `${id}-${place}` : undefined}
        autoComplete="off"
        value={query}
        onChange={(event) => {
          setQuery(event.currentTarget.value);
          setAt(0);
        }}
        onKeyDown={onKeyDown}
      />
      <div
        ref={list}
        id={`${id}-list`}
        className="sl-finder-list nowheel"
        role="listbox"
        tabIndex={-1}
        aria-label={label}
      >
        {found.map((item, i) => (
          <QuickPickRow
            key={item.id}
            item={item}
            id={`${id}-${i}`}
            place={i}
            active={i === place}
            heading={query === '' && item.group !== found[i - 1]?.group ? item.group : undefined}
            onChoose={() => onChoose(item)}
            onPoint={() => setAt(i)}
          />
        ))}
        {found.length === 0 && (
          <Text size="sm" c="dimmed" p="sm">
            {t(msg`No results`)}
          </Text>
        )}
      </div>
    </div>
  );
}

const STEPS: Readonly<Record<string, number>> = { ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8 };

interface QuickPickRowProps {
  readonly item: QuickPickItem;
  readonly id: string;
  readonly place: number;
  readonly active: boolean;
  readonly heading?: string;
  readonly onChoose: () => void;
  readonly onPoint: () => void;
}

function QuickPickRow({ item, id, place, active, heading, onChoose, onPoint }: QuickPickRowProps): ReactNode {
  return (
    <>
      {heading && (
        <div className="sl-finder-heading" role="presentation">
          {heading}
        </div>
      )}
      {/* biome-ignore lint/a11y/useKeyWithClickEvents: the text field handles the keys */}
      {/* biome-ignore lint/a11y/useFocusableInteractive: the field above keeps the focus */}
      <div
        id={id}
        data-place={place}
        role="option"
        aria-selected={active}
        aria-disabled={item.disabled || undefined}
        className="sl-finder-item"
        data-category={item.category}
        onPointerMove={onPoint}
        onClick={onChoose}
      >
        <span className="sl-finder-text">
          <span>{item.label}</span>
          {item.detail && <span className="sl-finder-detail">{item.detail}</span>}
        </span>
        {item.keys && (
          <Group gap={3} wrap="nowrap">
            {item.keys.map((key) => (
              <Kbd key={key} size="xs">
                {key}
              </Kbd>
            ))}
          </Group>
        )}
      </div>
    </>
  );
}
