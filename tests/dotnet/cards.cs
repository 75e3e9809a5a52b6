// Two cards, with arrays, optional arguments and addresses. Compiled with GtsMulti.cs.
using System;
using System.Threading;
using gts;

class Cards
{
    static void Accepted(short code)
    {
        if (code != 0) throw new Exception("refused: " + code);
    }

    static void Start(short card, int position)
    {
        mc.TTrapPrm trap = new mc.TTrapPrm();
        trap.acc = 0.2;
        trap.dec = 0.2;
        Accepted(mc.GT_Open(card));
        Accepted(mc.GT_ClrSts(card, 1, 8));
        Accepted(mc.GT_AxisOn(card, 2));
        Accepted(mc.GT_PrfTrap(card, 2));
        Accepted(mc.GT_SetTrapPrm(card, 2, ref trap));
        Accepted(mc.GT_SetVel(card, 2, 20));
        Accepted(mc.GT_SetPos(card, 2, position));
        Accepted(mc.GT_Update(card, 1 << 1));
    }

    static void Main()
    {
        int[] status = new int[8];
        double[] positions = new double[8];
        double position;
        mc.TTrigger trigger = new mc.TTrigger();
        Start(0, 100000);
        Start(1, -60000);
        do
        {
            Thread.Sleep(10);
            Accepted(mc.GT_GetSts(0, 1, status, 8));
        } while ((status[1] & 0x400) != 0);
        Accepted(mc.GT_GetPrfPos(0, 1, positions, 8, IntPtr.Zero));
        Accepted(mc.GT_GetPrfPos(1, 2, out position));
        Console.WriteLine(positions[1] + " " + position);
        trigger.encoder = 2;
        trigger.probeType = mc.CAPTURE_HOME;
        trigger.probeIndex = 1;
        trigger.sense = 1;
        trigger.loop = 3;
        trigger.lastPosition = -5;
        Accepted(mc.GT_SetTrigger(1, 1, ref trigger));
        Accepted(mc.GT_GetTrigger(1, 1, out trigger));
        Console.WriteLine(trigger.sense + " " + trigger.loop + " " + trigger.lastPosition);
        Accepted(mc.GT_Close(0));
        Accepted(mc.GT_Close(1));
    }
}
