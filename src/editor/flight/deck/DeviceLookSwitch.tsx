import { Switch } from '@mantine/core';
import type { ReactNode } from 'react';
import { useStore } from 'zustand';
import { msg } from '../../../messages/message.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useServices } from '../../services.tsx';
import { useEditor } from '../../state/context.tsx';
import { isCoarse } from '../inputDevice.ts';
import { beginDeviceLook, deviceLook, endDeviceLook } from '../touch/deviceLook.ts';

/** The device as a window: it shows what is behind it. Only where a hand can hold it. */
export function DeviceLookSwitch(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const { observerController } = useServices();
  const checked = useStore(deviceLook);
  return isCoarse ? (
    <Switch
      size="xs"
      label={t(msg`Look around by turning the device`)}
      checked={checked}
      onChange={({ currentTarget }) =>
        currentTarget.checked ? void beginDeviceLook(editor, observerController.inputs) : endDeviceLook()
      }
    />
  ) : null;
}
