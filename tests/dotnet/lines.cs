// samples/18_lines/host.c in C#: the same calls, with the same numbers. Compiled with declarations.cs
// and with Gts.cs.
using System;
using gts;

class Lines
{
    const short Crd = 1;

    static void Accepted(short code)
    {
        if (code == 0) return;
        Console.Error.WriteLine("refused: " + code);
        Environment.Exit(1);
    }

    static void SetUp()
    {
        mc.TCrdPrm crd = new mc.TCrdPrm();
        crd.dimension = 2;
        crd.profile1 = 1;
        crd.profile2 = 2;
        crd.synVelMax = 500;
        crd.synAccMax = 2;
        crd.setOriginFlag = 1;
        Accepted(mc.GT_AxisOn(1));
        Accepted(mc.GT_AxisOn(2));
        Accepted(mc.GT_SetCrdPrm(Crd, ref crd));
        Accepted(mc.GT_CrdClear(Crd, 0));
    }

    static void Line(int x, int y)
    {
        Accepted(mc.GT_LnXY(Crd, x, y, 100, 0.1, 0, 0));
    }

    static void Output(ushort value)
    {
        Accepted(mc.GT_BufIO(Crd, (ushort)mc.MC_GPO, 0xffff, value, 0));
    }

    static void Main()
    {
        short run;
        int segment;
        Accepted(mc.GT_Open(0, 1));
        SetUp();
        Line(200000, 0);
        Line(100000, 173205);
        Output(0x55);
        Line(-100000, 173205);
        Output(0xaa);
        Line(-200000, 0);
        Accepted(mc.GT_BufDelay(Crd, 400, 0));
        Line(-100000, -173205);
        Output(0x55);
        Accepted(mc.GT_BufDelay(Crd, 100, 0));
        Line(100000, -173205);
        Line(200000, 0);
        Accepted(mc.GT_CrdStart(Crd, 0));
        do
        {
            Accepted(mc.GT_CrdStatus(Crd, out run, out segment, 0));
        } while (run == 1);
        Accepted(mc.GT_Close());
    }
}
