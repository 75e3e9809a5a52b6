// Waits of .NET, each in milliseconds of the card, to ten of them: looks at the clock take some time,
// too. Compiled with Gts.cs.
using System;
using System.Diagnostics;
using System.Threading;
using gts;

class Times
{
    static uint before;

    static void Passed(string what)
    {
        uint now;
        mc.GT_GetClock(out now);
        Console.WriteLine(what + " " + (now - before + 5) / 10 * 10);
        before = now;
    }

    static void Main()
    {
        AutoResetEvent never = new AutoResetEvent(false);
        AutoResetEvent done = new AutoResetEvent(false);
        string version;
        mc.GT_Open();
        mc.GT_GetVersion(out version);
        Console.WriteLine(version);
        mc.GT_GetClock(out before);
        Stopwatch watch = Stopwatch.StartNew();
        Thread.Sleep(60000);
        Passed("Sleep");
        never.WaitOne(3000);
        Passed("WaitOne");
        Thread other = new Thread(() => { Thread.Sleep(700); done.Set(); });
        other.Start();
        done.WaitOne(5000);
        Passed("Set");
        other.Join();
        object monitor = new object();
        lock (monitor) Monitor.Wait(monitor, 250);
        Passed("Monitor");
        Timer timer = new Timer(state => done.Set(), null, 1500, Timeout.Infinite);
        done.WaitOne();
        Passed("Timer");
        timer.Dispose();
        Console.WriteLine("Stopwatch " + watch.ElapsedMilliseconds / 10);
        Console.WriteLine(DateTime.UtcNow.ToString("yyyy-MM-dd HH:mm"));
        mc.GT_Close();
    }
}
