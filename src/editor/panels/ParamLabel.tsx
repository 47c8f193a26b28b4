import { ActionIcon, Group, Text, Tooltip } from '@mantine/core';
import { IconRestore } from '@tabler/icons-react';
import type { ReactNode } from 'react';
import type { ParamValue } from '../../graph/document/document.ts';
import type { ParamSpec } from '../../graph/nodeType.ts';
import { msg } from '../../messages/message.ts';
import { useTexts } from '../language/languageStore.ts';

/** Title and help of a parameter. */
export function ParamLabel({ spec, id }: { readonly spec: ParamSpec; readonly id: string }): ReactNode {
  const { t } = useTexts();
  const text = (
    <Text size="sm" id={id} className="sl-param-label" truncate>
      {t(spec.title)}
    </Text>
  );
  return spec.help ? (
    <Tooltip label={t(spec.help)} position="left" multiline maw={260} openDelay={400}>
      {text}
    </Tooltip>
  ) : (
    text
  );
}

interface ResetProps {
  readonly set: ParamValue | undefined;
  readonly onChange: (value: undefined) => void;
}

/** Resets to the default; shown when another value is set. */
export function ResetButton({ set, onChange }: ResetProps): ReactNode {
  const { t } = useTexts();
  if (set === undefined) return null;
  return (
    <Tooltip label={t(msg`Back to the default`)} openDelay={400}>
      <ActionIcon
        size="xs"
        variant="subtle"
        color="gray"
        aria-label={t(msg`Back to the default`)}
        onClick={() => onChange(undefined)}
      >
        <IconRestore size={13} />
      </ActionIcon>
    </Tooltip>
  );
}

interface HeaderProps extends ResetProps {
  readonly spec: ParamSpec;
  readonly id: string;
  /** Beside the reset. */
  readonly children?: ReactNode;
}

/** Label and reset of a parameter, above a control as wide as the panel. */
export const ParamHeader = ({ spec, id, children, ...reset }: HeaderProps): ReactNode => (
  <Group gap={4} wrap="nowrap" justify="space-between">
    <ParamLabel spec={spec} id={id} />
    <Group gap={6} wrap="nowrap">
      {children}
      <ResetButton {...reset} />
    </Group>
  </Group>
);

/** Shown instead of a control when an edge drives the parameter. */
export function DrivenParam({ spec, by }: { readonly spec: ParamSpec; readonly by: string }): ReactNode {
  const { t } = useTexts();
  return (
    <Group gap={4} wrap="nowrap" justify="space-between" mih={26} aria-label={t(spec.title)} role="group">
      <ParamLabel spec={spec} id="" />
      <Text size="xs" c="dimmed" truncate>
        {t(msg`from ${by}`)}
      </Text>
    </Group>
  );
}
